/** The engine's bytes, which the build puts into this script as base64. */
import { fromBase64 } from "../data/unpacker";
import asDataUrl from "../../../build/wasm/quadmatch.wasm?url&inline";

export function engineBytes(): Uint8Array {
  return fromBase64(asDataUrl.slice(asDataUrl.indexOf(",") + 1));
}
