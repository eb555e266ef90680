/** All that takes time: reading, matching, carrying, merging, and making the report ready to be drawn. */
import { unpackBytes } from "../data/report";
import { SIDES } from "../data/header";
import { coarsened } from "../picture/coarse";
import type { ByteSource, Slot } from "./engine";
import { Engine, Lost, Refused } from "./engine";
import type { Chosen, Choice, Reply, Request } from "./messages";

interface Port {
  postMessage(reply: Reply, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<Request>) => void) | null;
}
const page = self as unknown as Port;

const MILLISECONDS_BETWEEN_NEWS = 80;

let engine: Engine | null = null;
let told = 0;

const listener = {
  stage: (text: string) => page.postMessage({ kind: "stage", text }),
  progress: (done: number, most: number) => {
    const now = performance.now();
    if (now - told < MILLISECONDS_BETWEEN_NEWS) return;
    told = now;
    page.postMessage({ kind: "progress", done, most });
  },
};

function bytesOf(file: Chosen): ByteSource {
  return {
    size: file.size,
    async piece(from, to) {
      try {
        return new Uint8Array(await file.slice(from, to).arrayBuffer());
      } catch (error) {
        // A folder, or a file that was taken away or changed since it was chosen.
        throw new Refused(`${file.name}: the file cannot be read (${error instanceof Error ? error.message : String(error)})`);
      }
    },
  };
}

async function read(slot: Slot, file: Chosen): Promise<void> {
  listener.stage(`reading ${file.name}`);
  for (const text of await engine!.read(slot, file.name, bytesOf(file))) page.postMessage({ kind: "warning", text });
}

function choose(choices: Choice[]): void {
  for (const [name, value] of choices) engine!.choose(name, value);
}

/** All buffers of a value, to be handed over instead of copied. */
function buffersOf(value: unknown, found = new Set<ArrayBuffer>()): Set<ArrayBuffer> {
  if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
  else if (Array.isArray(value)) {
    if (typeof value[0] === "object") value.forEach((one) => buffersOf(one, found));
  } else if (typeof value === "object" && value !== null) Object.values(value).forEach((one) => buffersOf(one, found));
  return found;
}

async function match(request: Request & { kind: "match" }): Promise<void> {
  engine = await Engine.start(request.engine, listener);
  choose(request.choices);
  await read("source", request.source);
  await read("target", request.target);
  const { header, bytes } = engine.match();
  listener.stage("making the picture");
  const report = unpackBytes(header, bytes);
  for (const side of SIDES) report.shown[side] = coarsened(report.meshes[side], report.match[side].partner, request.mostFaces);
  page.postMessage({ kind: "report", report }, [...buffersOf(report)]);
}

function handOut(name: string, bytes: Uint8Array, summary: string): void {
  page.postMessage({ kind: "file", name, bytes, summary }, [bytes.buffer as ArrayBuffer]);
}

async function serve(request: Request): Promise<void> {
  switch (request.kind) {
    case "match":
      return match(request);
    case "match file":
      listener.stage("writing the match file");
      return handOut(request.name, engine!.matchFile(), "");
    case "transfer": {
      const { bytes, summary } = engine!.transfer(request.name);
      return handOut(request.name, bytes, summary);
    }
    case "merge": {
      if (request.other) await read("other", request.other);
      choose(request.choices);
      const { bytes, summary } = engine!.merge(request.name);
      return handOut(request.name, bytes, summary);
    }
  }
}

page.onmessage = async ({ data }) => {
  try {
    await serve(data);
  } catch (error) {
    const text = error instanceof Error ? error.message : String(error);
    page.postMessage({ kind: "refused", text, lost: error instanceof Lost || !(error instanceof Refused) });
  }
};
