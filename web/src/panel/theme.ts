/** Dark or light: the reader's system decides until the reader does. */
import { button } from "./dom";

/** @param signal  ends listening to the system. */
export function themeButton(changed: () => void, signal?: AbortSignal): HTMLButtonElement {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const root = document.documentElement;
  const isDark = () => (root.dataset.theme ? root.dataset.theme === "dark" : dark.matches);
  const made = button("", { id: "theme" }, () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    tell();
  });
  const tell = () => {
    made.textContent = isDark() ? "Light" : "Dark";
    made.setAttribute("aria-label", `Switch to ${isDark() ? "light" : "dark"} colours`);
    changed();
  };
  dark.addEventListener("change", tell, { signal });
  tell();
  return made;
}
