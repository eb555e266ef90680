import { describe, expect, test } from "vitest";
import { fromBase64, hasBit, unpackBits, Unpacker } from "../src/data/unpacker";

describe("numbers out of few bytes", () => {
  test("seven bits a byte, the lowest first, beyond 32 bits", () => {
    const unpacker = new Unpacker(Uint8Array.from([0, 127, 0x80, 1, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x7f]));
    expect(unpacker.number()).toBe(0);
    expect(unpacker.number()).toBe(127);
    expect(unpacker.number()).toBe(128);
    expect(unpacker.number()).toBe(2 ** 49 - 1);
    expect(unpacker.done).toBe(true);
  });

  test("steps go both ways: 0, 1, 2, ... stand for 0, -1, +1, -2, +2", () => {
    const unpacker = new Unpacker(Uint8Array.from([0, 1, 2, 3, 4]));
    expect([0, 1, 2, 3, 4].map(() => unpacker.step(10))).toEqual([10, 9, 11, 8, 12]);
  });

  test("a list is its length and steps from the number before", () => {
    const unpacker = new Unpacker(Uint8Array.from([3, 10, 4, 1]));
    expect([...unpacker.list()]).toEqual([5, 7, 6]);
  });

  test("data that end too early are said to, not read on", () => {
    expect(() => new Unpacker(Uint8Array.from([0x80])).number()).toThrow(/end too early/);
  });

  test("numbers of any width stand without gaps", () => {
    expect([...unpackBits(Uint8Array.from([0b11010001, 0b1]), 3, 3)]).toEqual([1, 2, 7]);
    expect([...unpackBits(Uint8Array.from([0xf1, 0xff, 0xff, 0xff, 0x1f, 0, 0, 0, 0]), 32, 2)]).toEqual([0xfffffff1, 0x1f]);
    expect(() => unpackBits(new Uint8Array(1), 3, 3)).toThrow(/end too early/);
  });

  test("bits stand lowest first in their bytes", () => {
    const bits = Uint8Array.from([0b00000101, 0b1]);
    expect([0, 1, 2, 3, 8, 9].map((i) => hasBit(bits, i))).toEqual([true, false, true, false, true, false]);
  });

  test("base64 of every length of the last group", () => {
    expect([...fromBase64("")]).toEqual([]);
    expect([...fromBase64("/w==")]).toEqual([255]);
    expect([...fromBase64("AP8=")]).toEqual([0, 255]);
    expect([...fromBase64("AAEC")]).toEqual([0, 1, 2]);
  });
});
