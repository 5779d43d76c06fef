/** Forms that block and unblock links, and send a message on behalf of a robot. */
import { button, el, fill } from "crs/dom.js";
import { change, changeOrSay, choice, entry, field, showErrors, setOptions, typed } from "crs/change.js";

/** @param {any} model @returns {{shut: HTMLElement, send: HTMLElement}} */
export function linkForms(model) {
  const list = el("div.outages");
  const [channel, from, to] = [choice([["", "all channels"]]), choice([["", "any robot"]]), choice([["", "any robot"]])];
  const [at, lasts] = [field("from", entry({ placeholder: "now" }), "s"), field("for", entry({ placeholder: "the rest of the run" }), "s")];
  const shut = el("form.fields", { onsubmit: async (event) => {
    event.preventDefault();
    const way = words([["", channel.value], ["from", from.value], ["to", to.value]]) || "all";
    const wrong = await change(model, `shut ${way}${words([["at", typed(at.input)], ["for", typed(lasts.input)]], " ")}`);
    showErrors([at, lasts], wrong);
  } },
  field("channel", channel).row, field("sent by", from).row, field("sent to", to).row, at.row, lasts.row,
  el("div.row-end", {}, el("button.primary", { type: "submit" }, "Block")));

  const [by, addressee, on] = [choice([]), choice([["", "all"]]), choice([])];
  const [kind, text] = [field("type", entry({ value: "0" })), field("text", entry({ placeholder: "content" }))];
  const send = el("form.fields", { onsubmit: async (event) => {
    event.preventDefault();
    const way = words([["to", addressee.value], ["on", on.value], ["type", typed(kind.input)]], " ");
    const wrong = await change(model, `message ${by.value}${way}: ${text.input.value}`);
    kind.setError(wrong.includes("type") ? wrong : "");
    text.setError(wrong && !wrong.includes("type") ? wrong : "");
  } },
  field("sent by", by).row, field("sent to", addressee).row, field("channel", on).row, kind.row, text.row,
  el("div.row-end", {}, el("button.primary", { type: "submit" }, "Send")));

  const show = () => {
    const names = (model.run?.rosters.at(-1)?.robots ?? []).slice(0, 1000).map((each) => [each, each]);
    const channels = (model.panel?.channels ?? []).map((each) => [each, each]);
    setOptions(channel, [["", "all channels"], ...channels]);
    setOptions(on, channels);
    for (const each of [from, to]) setOptions(each, [["", "any robot"], ...names]);
    setOptions(by, names);
    setOptions(addressee, [["", "all"], ...names]);
    const outages = model.panel?.outages ?? [];
    fill(list, ...outages.map((each) => {
      const way = words([["", each.channel], ["from", each.from], ["to", each.to]]) || "all";
      const until = each.until === null ? "" : ` to ${+each.until.toFixed(3)} s`;
      return el("div.in-force", {}, el("span", {}, way, el("span.times", {}, ` from ${+each.at.toFixed(3)} s${until}`)),
        button({ text: "Unblock", title: `Unblock ${way}`, onclick: () => changeOrSay(model, `open ${way}`) }));
    }));
  };
  for (const kind of ["panel", "hello", "roster", "look"]) model.on(kind, show);
  return { shut: el("div.link-forms", {}, shut, list), send: el("div.link-forms", {}, send) };
}

/** Words of a command: those that have a value. */
function words(pairs, before = "") {
  const found = pairs.filter(([, value]) => value).map(([word, value]) => (word ? `${word} ${value}` : value));
  return found.length ? before + found.join(" ") : "";
}
