/** The page's folder on loopback, as any web server would serve it. */
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { ROOT } from "./root.mjs";

const FOLDER = join(ROOT, "build/page");
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };

/** Resolves to an address, and a function that ends it. */
export function serve() {
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
    try {
      const bytes = await readFile(join(FOLDER, normalize(path.endsWith("/") ? `${path}index.html` : path)));
      response.writeHead(200, { "Content-Type": TYPES[extname(path) || ".html"] ?? "application/octet-stream" });
      response.end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  return new Promise((resolve) => {
    server.listen(0, "127.0.0.1", () => {
      resolve({ address: `http://127.0.0.1:${server.address().port}/`, end: () => server.close() });
    });
  });
}
