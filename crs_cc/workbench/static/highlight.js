/** Colours of C source, a line at a time. */

const KEYWORDS =
  "auto break case char const continue default do double else enum extern float for goto if inline int long register " +
  "restrict return short signed sizeof static struct switch typedef union unsigned void volatile while";
const WORDS = new Set(KEYWORDS.split(" "));
const TOKEN = /(\/\*.*?(?:\*\/|$)|\/\/.*)|("(?:\\.|[^"\\])*"?|'(?:\\.|[^'\\])*'?)|(^\s*#\s*\w+)|([A-Za-z_]\w*)|(\b\d[\w.]*)/g;

/**
 * @param {string} line @param {boolean} isComment whether it begins inside a comment
 * @returns {{parts: [string, string][], isComment: boolean}} text and class of each part
 */
export function highlight(line, isComment) {
  /** @type {[string, string][]} */
  const parts = [];
  let at = 0;
  if (isComment) {
    const end = line.indexOf("*/");
    if (end < 0) return { parts: [[line, "comment"]], isComment: true };
    parts.push([line.slice(0, end + 2), "comment"]);
    at = end + 2;
  }
  let isOpen = false;
  TOKEN.lastIndex = at;
  for (let found = TOKEN.exec(line); found; found = TOKEN.exec(line)) {
    if (found.index > at) parts.push([line.slice(at, found.index), ""]);
    const [text, comment, string, directive, word, number] = found;
    if (comment) isOpen = text.startsWith("/*") && !text.endsWith("*/");
    const kind = comment ? "comment" : string ? "string" : directive ? "directive" : number ? "number" : WORDS.has(word) ? "keyword" : "";
    parts.push([text, kind]);
    at = found.index + text.length;
  }
  if (at < line.length) parts.push([line.slice(at), ""]);
  return { parts, isComment: isOpen };
}
