/** The slider and the button that replay the growth, wave by wave. */
import type { MatchData } from "../data/match";
import { button, element, grouped } from "./dom";

const MILLISECONDS = 6000;
const MOST_FRAMES = 120;

export interface Replay {
  element: HTMLElement;
  /** Stop, and show a wave. */
  show(wave: number): void;
  step(by: number): void;
  toggle(): void;
  stop(): void;
}

export function describeWave(match: MatchData, wave: number): string {
  return `wave ${grouped(wave + 1)} of ${grouped(match.waveCount)}: ${grouped(match.matchedAfter[wave])} faces matched`;
}

export function makeReplay(match: MatchData, changed: (wave: number) => void): Replay {
  const last = match.waveCount - 1;
  let wave = last;
  let timer = 0;
  const slider = element("input", {
    type: "range",
    id: "wave",
    min: "0",
    max: String(last),
    value: String(last),
    "aria-label": "Wave of growth",
  });
  const told = element("output", { for: "wave", id: "wave-text" });
  const play = button("Play", { id: "play", "aria-keyshortcuts": "Space" }, () => replay.toggle());

  const set = (next: number) => {
    wave = Math.min(last, Math.max(0, next));
    slider.value = String(wave);
    told.textContent = describeWave(match, wave);
    slider.setAttribute("aria-valuetext", told.textContent);
    changed(wave);
  };
  const stop = () => {
    clearInterval(timer);
    timer = 0;
    play.textContent = "Play";
  };
  const replay: Replay = {
    element: element("div", { class: "replay", role: "group", "aria-label": "Replay of the growth" }, play, slider, told),
    show(next) {
      stop();
      set(next);
    },
    step(by) {
      replay.show(wave + by);
    },
    stop,
    toggle() {
      if (timer !== 0) {
        stop();
        return;
      }
      const frames = Math.min(MOST_FRAMES, match.waveCount);
      const stride = Math.max(1, Math.ceil(match.waveCount / frames));
      if (wave === last) set(0);
      play.textContent = "Pause";
      timer = window.setInterval(() => {
        set(wave + stride);
        if (wave === last) stop();
      }, Math.max(40, MILLISECONDS / frames));
    },
  };
  slider.addEventListener("input", () => {
    stop();
    set(Number(slider.value));
  });
  set(last);
  if (last === 0) {
    play.disabled = slider.disabled = true;
    play.title = "This match was made without waves";
  }
  return replay;
}
