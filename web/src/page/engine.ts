/** The engine in WebAssembly, with texts and bytes instead of places in its memory (apps/page/exports.cpp). */
import { systemCalls } from "./wasi";

/** Which mesh: source and target of a match are base and one edit of a merge, `other` is the other edit. */
export const SLOTS = ["source", "target", "other"] as const;
export type Slot = (typeof SLOTS)[number];

export interface Listener {
  stage(text: string): void;
  progress(done: number, most: number): void;
}

/** A file's bytes, piece by piece. */
export interface ByteSource {
  readonly size: number;
  piece(from: number, to: number): Promise<Uint8Array>;
}

/** Bad input: the sentence is for the user, and the same as of the command line. */
export class Refused extends Error {}

/** The engine is lost; another one can be started. */
export class Lost extends Error {}

interface Exports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  start(): void;
  reserve(size: number): number;
  reserve_file(size: number): number;
  answer_count(): number;
  answer_data(index: number): number;
  answer_size(index: number): number;
  forget(): void;
  read(slot: number, name: number, nameSize: number): number;
  choose(name: number, nameSize: number, value: number, valueSize: number): number;
  match(): number;
  match_file(): number;
  transfer(name: number, nameSize: number): number;
  merge(name: number, nameSize: number): number;
}

const PIECE = 1 << 24;
/** WebAssembly of today counts in 32 bits. */
const MOST_BYTES = 0xfff00000;
const OUT_OF_MEMORY =
  "there is not enough memory: a page has 4 GB at most; take smaller meshes, or the command line, which has all of it";

export class Engine {
  private constructor(private readonly exports: Exports) {}

  static async start(module: WebAssembly.Module, listener: Listener): Promise<Engine> {
    let exports: Exports;
    let lastWords = "";
    const text = (at: number, size: number) => new TextDecoder().decode(new Uint8Array(exports.memory.buffer, at >>> 0, size));
    const instance = await WebAssembly.instantiate(module, {
      wasi_snapshot_preview1: systemCalls(() => exports.memory, (words) => (lastWords += words)) as WebAssembly.ModuleImports,
      page: {
        stage: (at: number, size: number) => listener.stage(text(at, size)),
        progress: (done: number, most: number) => listener.progress(done, most),
        out_of_memory: () => {
          throw new Lost(OUT_OF_MEMORY);
        },
      },
    });
    exports = instance.exports as unknown as Exports;
    exports._initialize();
    exports.start();
    return new Engine(guarded(exports, () => lastWords));
  }

  /** What it has taken of the machine; it gives nothing back before it is gone. */
  get memoryBytes(): number {
    return this.exports.memory.buffer.byteLength;
  }

  /** Take a mesh in. @returns what the command line would warn of. */
  async read(slot: Slot, name: string, source: ByteSource): Promise<string[]> {
    const tooLarge = () => new Refused(`${name}: the file does not fit into memory; split it`);
    if (source.size > MOST_BYTES) throw tooLarge();
    const bytes = this.exports.reserve_file(source.size) >>> 0;
    if (bytes === 0) throw tooLarge();
    for (let from = 0; from < source.size; from += PIECE) {
      const piece = await source.piece(from, Math.min(source.size, from + PIECE));
      new Uint8Array(this.exports.memory.buffer, bytes + from, piece.length).set(piece);
    }
    return this.texts(this.exports.read(SLOTS.indexOf(slot), ...this.put(name)));
  }

  /** Set an option by its name on the command line without the dashes. */
  choose(name: string, value: string): void {
    this.texts(this.exports.choose(...this.put(name), ...this.put(value)));
  }

  /** Match source and target. @returns header and bytes of the report. */
  match(): { header: string; bytes: Uint8Array } {
    const [header, bytes] = this.answers(this.exports.match());
    return { header: new TextDecoder().decode(header), bytes };
  }

  matchFile(): Uint8Array {
    return this.answers(this.exports.match_file())[0];
  }

  /** The target with the source's data. */
  transfer(name: string): { bytes: Uint8Array; summary: string } {
    return product(this.answers(this.exports.transfer(...this.put(name))));
  }

  /** Both edits of the source brought together. */
  merge(name: string): { bytes: Uint8Array; summary: string } {
    return product(this.answers(this.exports.merge(...this.put(name))));
  }

  /** A text in the engine's memory, which the call it is for takes back. */
  private put(text: string): [at: number, size: number] {
    const bytes = new TextEncoder().encode(text);
    const at = this.exports.reserve(bytes.length) >>> 0;
    new Uint8Array(this.exports.memory.buffer, at, bytes.length).set(bytes);
    return [at, bytes.length];
  }

  /** Copies of what a call came to. */
  private answers(succeeded: number): Uint8Array[] {
    const found: Uint8Array[] = [];
    for (let i = 0; i < this.exports.answer_count(); ++i) {
      // Above 2 GB places in memory come as negative numbers.
      found.push(new Uint8Array(this.exports.memory.buffer, this.exports.answer_data(i) >>> 0, this.exports.answer_size(i) >>> 0).slice());
    }
    this.exports.forget();
    if (succeeded === 0) throw new Refused(new TextDecoder().decode(found[0]));
    return found;
  }

  private texts(succeeded: number): string[] {
    return this.answers(succeeded).map((bytes) => new TextDecoder().decode(bytes));
  }
}

function product([bytes, summary]: Uint8Array[]) {
  return { bytes, summary: new TextDecoder().decode(summary) };
}

/** The same functions, whose traps tell what a user can make of them. */
function guarded(exports: Exports, lastWords: () => string): Exports {
  const safe = (call: (...numbers: number[]) => number) => (...numbers: number[]) => {
    try {
      return call(...numbers);
    } catch (error) {
      if (error instanceof Lost) throw error;
      const reason = [lastWords().trim(), error instanceof Error ? error.message : String(error)].filter(Boolean).join("; ");
      throw new Lost(`internal error: the engine stopped (${reason}); please report it`);
    }
  };
  const entries = Object.entries(exports).map(([name, value]) => [name, typeof value === "function" ? safe(value) : value]);
  return Object.fromEntries(entries) as Exports;
}
