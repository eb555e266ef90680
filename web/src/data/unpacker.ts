/** Numbers out of few bytes: reads what src/report/packer.cpp writes, in the same order. */
export class Unpacker {
  private at = 0;

  constructor(private readonly bytes: Uint8Array) {}

  get done(): boolean {
    return this.at >= this.bytes.length;
  }

  /** Seven bits a byte, the lowest first. Numbers up to 2^53. */
  number(): number {
    let value = 0;
    let scale = 1;
    for (;;) {
      if (this.at >= this.bytes.length) throw new Error("the report's data end too early; make the report again");
      const byte = this.bytes[this.at++];
      value += (byte & 0x7f) * scale;
      if (byte < 0x80) return value;
      scale *= 128;
    }
  }

  /** The number that is one step from the one before. */
  step(before: number): number {
    const zigzag = this.number();
    return zigzag % 2 === 0 ? before + zigzag / 2 : before - (zigzag + 1) / 2;
  }

  /** How many, then each as the step from the one before. */
  list(): Uint32Array {
    const numbers = new Uint32Array(this.number());
    let before = 0;
    for (let i = 0; i < numbers.length; ++i) numbers[i] = before = this.step(before);
    return numbers;
  }
}

/** Numbers of `width` bits each, the lowest first, without gaps. */
export function unpackBits(bytes: Uint8Array, width: number, count: number): Uint32Array {
  if (bytes.length * 8 < count * width) throw new Error("the report's data end too early; make the report again");
  const numbers = new Uint32Array(count);
  let held = 0;
  let bits = 0;
  let at = 0;
  for (let i = 0; i < count; ++i) {
    // Below 2^40, so no bit of the sum is lost.
    for (; bits < width; bits += 8) held += bytes[at++] * 2 ** bits;
    numbers[i] = held % 2 ** width;
    held = Math.floor(held / 2 ** width);
    bits -= width;
  }
  return numbers;
}

export function hasBit(bits: Uint8Array, index: number): boolean {
  return (bits[index >> 3] & (1 << (index & 7))) !== 0;
}

/** Bytes of a text in base64. */
export function fromBase64(text: string): Uint8Array {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes;
}
