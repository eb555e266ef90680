/** The worker as the page has it: one at a time, and the newest wish wins. */
import Worker from "./worker?worker&inline";
import type { Reply, Request } from "./messages";

/** The engine, compiled once however many workers come and go. Its bytes stand in a script of their own: the page may load
 *  scripts from where it came from, and nothing else from anywhere (the policy in index.html). */
let compiled: Promise<WebAssembly.Module> | null = null;
export function compiledEngine(): Promise<WebAssembly.Module> {
  compiled ??= import("./engine_bytes").then(({ engineBytes }) => WebAssembly.compile(engineBytes() as BufferSource));
  return compiled;
}

export class Work {
  private worker: InstanceType<typeof Worker> | null = null;
  private warming: InstanceType<typeof Worker> | null = null;

  constructor(private readonly heard: (reply: Reply) => void) {}

  /**
   * Do some work for nothing. A browser makes fast machine code of what has run for a while, for all workers at once; so
   * the first match that counts does not wait for it.
   */
  warm(request: Request): void {
    const worker = new Worker();
    this.warming = worker;
    const done = () => worker.terminate();
    worker.onerror = done;
    worker.onmessage = ({ data }: MessageEvent<Reply>) => {
      if (data.kind === "report" || data.kind === "refused") done();
    };
    worker.postMessage(request);
  }

  /** End whatever is going on, and begin with this. */
  begin(request: Request): void {
    this.end();
    this.warming?.terminate();
    const worker = new Worker();
    this.worker = worker;
    // A worker that was ended may have said something that is still on its way.
    worker.onmessage = ({ data }: MessageEvent<Reply>) => {
      if (this.worker === worker) this.heard(data);
    };
    worker.onerror = (event) => {
      if (this.worker === worker) this.heard({ kind: "refused", text: `internal error: ${event.message}; please report it`, lost: true });
    };
    worker.postMessage(request);
  }

  /** A further wish of the same worker. */
  ask(request: Request): void {
    this.worker?.postMessage(request);
  }

  /** At once, whatever it is doing. */
  end(): void {
    this.worker?.terminate();
    this.worker = null;
  }
}
