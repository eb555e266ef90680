/** Pairs to begin with, out of examples/; each file stands in a script of its own and is loaded when it is asked for. */

export interface Example {
  title: string;
  files: [source: string, target: string];
}

export const EXAMPLES: readonly Example[] = [
  { title: "A bear, and one without ears", files: ["bear.obj", "bear_no_ears_posed.obj"] },
  { title: "A shirt, long and short sleeves", files: ["shirt_long.obj", "shirt_short.obj"] },
  { title: "Figures 4.1 and 4.2 of the paper", files: ["fig_4_1.obj", "fig_4_2.obj"] },
];

const LOADERS = import.meta.glob<string>("../../../examples/*.obj", { query: "?raw", import: "default" });

export async function exampleFiles({ files }: Example): Promise<File[]> {
  const texts = await Promise.all(files.map((name) => LOADERS[`../../../examples/${name}`]()));
  return texts.map((text, i) => new File([text], files[i]));
}
