/** The debugger's console: its commands, with completion and history. */
import { el, fill } from "crs/dom.js";

const MAX = 500; // lines

/** @type {import("./index.js").Panel} */
export const commandLine = {
  id: "console",
  title: "Console",
  side: "right",
  needs: "debug",
  make(root, model, _look, page) {
    const log = el("div.log", { role: "log", "aria-label": "console" });
    const words = el("div.words");
    const input = el("input", { type: "text", placeholder: "print front, break turn, info state, degrade robot0 sonar.3 dead, help", "aria-label": "command of the debugger", spellcheck: false, autocomplete: "off" });
    root.append(log, words, el("div.prompt", {}, el("span", {}, "(crs)"), input));
    const typed = [""];
    let at = 0;

    const add = (kind, text, places = []) => {
      const [, number, rest] = /^@(\d+)(\s.*)$/s.exec(text) ?? [];
      const place = places[Number(number) - 1]; // of the numbers of a list, which the next list changes
      const link = place && el("button.link", { type: "button", title: "Go there", onclick: () => page.go(...place) }, `@${number}`);
      log.append(el(`div.${kind}`, {}, ...(link ? [link, rest] : [text])));
      while (log.children.length > MAX) log.firstChild.remove();
      log.scrollTop = log.scrollHeight;
    };

    /** Execute a line; `isField`: its error is shown elsewhere. @returns {Promise<{error: string}>} */
    page.console = async (line, isField = false) => {
      add("typed", `(crs) ${line}`);
      const answer = await model.channel.request("console", { line }).catch((error) => ({ lines: [["error", error.message]], places: [] }));
      for (const [kind, text] of answer.lines) add(kind, text, answer.places);
      const last = answer.lines.find(([kind]) => kind === "error");
      if (last && !isField) model.notify(last[1], true);
      return { error: last?.[1] ?? "" };
    };

    const complete = async () => {
      const found = await model.request("complete", { line: input.value });
      if (!found) return;
      let [same] = found.words;
      for (const word of found.words) while (!word.startsWith(same)) same = same.slice(0, -1);
      if (same) input.value = input.value.slice(0, found.start) + same + (found.words.length === 1 ? " " : "");
      fill(words, ...(found.words.length > 1 ? found.words.slice(0, 40).map((word) => el("span", {}, word)) : []));
    };

    input.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key === "Tab" && input.value) {
        event.preventDefault();
        complete();
      } else if (event.key === "Enter") {
        if (input.value) typed.push(input.value);
        page.console(input.value);
        at = typed.length;
        input.value = "";
        fill(words);
      } else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
        at = Math.min(typed.length, Math.max(1, at + (event.key === "ArrowUp" ? -1 : 1)));
        input.value = typed[at] ?? "";
        event.preventDefault();
      } else if (event.key === "Escape") input.blur();
    });
    page.focusConsole = () => input.focus();
  },
};
