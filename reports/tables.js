// Tables that a script may sort by the pointer or the keyboard, and rows that a reader may choose by verdict or word.
// Without it tables stand in the order in which they were written, all rows shown.
"use strict";
(() => {
  const key = (cell) => {
    if (cell === undefined) return "";
    if (cell.dataset.value !== undefined) return Number(cell.dataset.value);
    const text = cell.textContent.trim().replace(/\u2212/g, "-");
    const raised = text.replace(/\s*\u00d7\s*10([\u207b\u2070\u00b9\u00b2\u00b3\u2074-\u2079]+)/, (_, power) => "e" +
      power.replace(/./g, (c) => c === "\u207b" ? "-" : "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079".indexOf(c)));
    const number = /^[-+]?\d/.test(raised) ? parseFloat(raised) : NaN;
    return Number.isNaN(number) ? text.toLowerCase() : number;
  };
  // Numbers before words; what says nothing last.
  const order = (a, b) => {
    if (typeof a === typeof b) return a < b ? -1 : a > b ? 1 : 0;
    return typeof a === "number" ? -1 : 1;
  };

  const sort = (table, head, column) => {
    const down = head.getAttribute("aria-sort") === "ascending";
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    for (const body of table.tBodies) {
      const rows = [...body.rows].filter((row) => !row.classList.contains("group"));
      const keyed = rows.map((row) => [key(row.cells[column]), row]);
      keyed.sort((a, b) => down ? order(b[0], a[0]) : order(a[0], b[0]));
      body.append(...keyed.map((pair) => pair[1]));
    }
  };

  for (const table of document.querySelectorAll("table")) {
    if (!table.tHead || [...table.tBodies].every((body) => body.rows.length < 2)) continue;
    [...table.tHead.rows[0].cells].forEach((head, column) => {
      const button = document.createElement("button");
      button.className = "sort";
      button.append(...head.childNodes);
      button.addEventListener("click", () => sort(table, head, column));
      head.append(button);
    });
  }

  const matrices = [...document.querySelectorAll("table.matrix")];
  const rows = matrices.flatMap((table) => [...table.tBodies[0].rows]);
  if (rows.length < 2) return;
  const bar = document.createElement("form");
  bar.className = "filters";
  bar.addEventListener("submit", (event) => event.preventDefault());
  const word = document.createElement("input");
  word.type = "search";
  word.setAttribute("aria-label", "show only cases whose name contains");
  const count = document.createElement("span");
  count.setAttribute("role", "status");
  let chosen = "";
  const apply = () => {
    const text = word.value.trim().toLowerCase();
    let shown = 0;
    for (const row of rows) {
      const named = row.cells[0].textContent.toLowerCase().includes(text);
      row.hidden = !(named && (chosen === "" || row.dataset.verdict === chosen));
      shown += !row.hidden;
    }
    count.textContent = shown + " of " + rows.length + " runs";
    for (const button of bar.querySelectorAll("button")) button.setAttribute("aria-pressed", button.value === chosen);
  };
  const present = new Set(rows.map((row) => row.dataset.verdict));
  for (const verdict of ["", "fail", "inconclusive", "pass", "info"]) {
    if (verdict && !present.has(verdict)) continue;
    const button = bar.appendChild(document.createElement("button"));
    button.type = "button";
    button.value = verdict;
    button.textContent = verdict ? verdict.toUpperCase() : "all";
    button.addEventListener("click", () => { chosen = verdict; apply(); });
  }
  word.placeholder = "name of a case";
  word.addEventListener("input", apply);
  bar.append(word, count);
  document.querySelector(".overview main").prepend(bar);
  apply();
})();
