/**
 * What the engine's C library asks of a system, answered for one that has a clock and nothing else: no files, no
 * environment, no network. https://github.com/WebAssembly/WASI/blob/main/legacy/preview1/docs.md
 */

const SUCCESS = 0;
const BAD_DESCRIPTOR = 8;
const STANDARD_ERROR = 2;

/** The functions of `wasi_snapshot_preview1`. @param memory  of the engine. */
export function systemCalls(memory: () => WebAssembly.Memory, print: (text: string) => void) {
  const view = () => new DataView(memory().buffer);
  const none = () => BAD_DESCRIPTOR;
  return {
    clock_time_get(_clock: number, _precision: bigint, into: number): number {
      view().setBigUint64(into >>> 0, BigInt(Math.round(performance.now() * 1e6)), true);
      return SUCCESS;
    },
    environ_sizes_get(count: number, size: number): number {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return SUCCESS;
    },
    environ_get: () => SUCCESS,
    /** Only what a failing runtime says is ever written. */
    fd_write(descriptor: number, pieces: number, count: number, written: number): number {
      if (descriptor !== STANDARD_ERROR) return BAD_DESCRIPTOR;
      let size = 0;
      for (let i = 0; i < count; ++i) {
        const at = view().getUint32(pieces + 8 * i, true);
        const length = view().getUint32(pieces + 8 * i + 4, true);
        print(new TextDecoder().decode(new Uint8Array(memory().buffer, at, length)));
        size += length;
      }
      view().setUint32(written, size, true);
      return SUCCESS;
    },
    fd_close: none,
    fd_fdstat_get: none,
    fd_fdstat_set_flags: none,
    fd_prestat_get: none,
    fd_prestat_dir_name: none,
    fd_read: none,
    fd_pread: none,
    fd_seek: none,
    fd_sync: none,
    fd_filestat_get: none,
    path_filestat_get: none,
    path_open: none,
    path_readlink: none,
    path_rename: none,
    path_unlink_file: none,
    proc_exit(status: number): never {
      throw new Error(`the engine ended with status ${status}`);
    },
  };
}
