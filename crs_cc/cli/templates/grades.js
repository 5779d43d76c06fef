"use strict";
for (const table of document.querySelectorAll("table.grades")) {
  const heads = [...table.tHead.rows[0].cells];
  const body = table.tBodies[0];
  const key = (row, column) => {
    const cell = row.cells[column];
    const text = cell.dataset.key ?? cell.textContent.trim();
    return text !== "" && isFinite(text) ? Number(text) : text.toLowerCase();
  };
  const compare = (left, right) =>
    typeof left === typeof right ? (left < right ? -1 : Number(left > right))
      : typeof left === "number" ? -1 : 1;
  heads.forEach((head, column) => {
    const button = document.createElement("button");
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const down = head.getAttribute("aria-sort") === "ascending";
      heads.forEach((each) => each.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      const rows = [...body.rows];
      rows.sort((left, right) => (down ? -1 : 1) * compare(key(left, column), key(right, column)));
      body.append(...rows);
    });
  });
}
