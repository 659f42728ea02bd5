"use strict";
(() => {
  const form = document.getElementById("controls");
  if (!form) return;
  const list = document.getElementById("list");
  const search = document.getElementById("search");
  const shown = document.getElementById("shown");
  const nothing = document.getElementById("nothing");
  const value = (id) => document.getElementById(id)?.value ?? "";
  const original = [...list.children];
  const findings = [...list.querySelectorAll("article")].map((node) => ({
    node,
    details: node.querySelector("details"),
    group: node.parentElement,
    text: (node.dataset.path + " " + node.dataset.rule + " " + node.textContent).toLowerCase(),
  }));
  const levels = ["error", "warning", "info"];

  /* Whether one level alone is to be seen. */
  const boxes = [...form.querySelectorAll("[name=level]")];
  const isAlone = (level) => boxes.length > 1 && boxes.every((box) => box.checked === (box.value === level));

  /* The counts at the top show one level alone, or all levels again. */
  const cards = [...document.querySelectorAll(".counts li:not(.none)")].map((card) => {
    const level = card.dataset.level;
    const button = document.createElement("button");
    button.type = "button";
    button.append(...card.childNodes);
    card.append(button);
    button.addEventListener("click", () => {
      const all = isAlone(level);
      for (const box of boxes) box.checked = all || box.value === level;
      filter();
    });
    return { button, level };
  });

  /* Which findings are to be seen. */
  const filter = () => {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const on = new Set([...form.querySelectorAll("[name=level]:checked")].map((box) => box.value));
    const [rule, application] = [value("rule"), value("application")];
    let count = 0;
    for (const { node, text } of findings) {
      const data = node.dataset;
      const fits = on.has(data.level) && (!rule || data.rule === rule) &&
        (!application || data.applications.split(" ").includes(application)) &&
        words.every((word) => text.includes(word));
      node.hidden = !fits;
      count += fits ? 1 : 0;
    }
    for (const group of list.children) group.hidden = !group.querySelector("article:not([hidden])");
    nothing.hidden = count > 0;
    for (const { button, level } of cards) button.setAttribute("aria-pressed", String(isAlone(level)));
    shown.textContent = count === findings.length ? `${count} findings` : `${count} of ${findings.length} findings`;
  };

  /* The same articles under other headings. */
  const order = () => {
    const key = value("order");
    list.classList.toggle("mixed", key !== "path");
    if (key === "path") {
      for (const { node, group } of findings) group.append(node);
      list.replaceChildren(...original);
      return;
    }
    const groups = new Map();
    for (const { node } of findings) {
      const name = node.dataset[key];
      if (!groups.has(name)) groups.set(name, []);
      groups.get(name).push(node);
    }
    const names = [...groups.keys()].sort((a, b) =>
      key === "level" ? levels.indexOf(a) - levels.indexOf(b) : a < b ? -1 : 1);
    list.replaceChildren(...names.map((name) => {
      const section = document.createElement("section");
      section.className = "group";
      const heading = document.createElement("h2");
      heading.textContent = `${name}: ${groups.get(name).length}`;
      section.append(heading, ...groups.get(name));
      return section;
    }));
  };

  const fold = (open) => findings.forEach(({ node, details }) => { if (!node.hidden) details.open = open; });

  /* A link to a finding or a rule opens what it leads to, filtered out or not. */
  const follow = () => {
    const id = decodeURIComponent(location.hash.slice(1));
    if (!id) return;
    const hidden = document.getElementById(id)?.closest("[hidden]");
    if (hidden || (id.startsWith("file-") && value("order") !== "path")) reset();
    const target = document.getElementById(id);
    if (!target) return;
    const details = target.matches("details") ? target : target.matches("article") && target.querySelector("details");
    if (details) details.open = true;
    target.scrollIntoView();
  };

  const reset = () => {
    form.reset();
    order();
    filter();
  };

  const step = (by) => {
    const visible = findings.map(({ node }) => node)
      .filter((node) => !node.hidden)
      .sort((a, b) => (a.compareDocumentPosition(b) & Node.DOCUMENT_POSITION_FOLLOWING ? -1 : 1));
    const here = visible.indexOf(document.activeElement?.closest?.("article"));
    const next = here < 0 ? (by > 0 ? 0 : visible.length - 1) : Math.min(Math.max(here + by, 0), visible.length - 1);
    visible[next]?.querySelector("summary").focus();
  };

  form.addEventListener("input", (event) => { if (event.target.id === "order") order(); filter(); });
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("reset", () => setTimeout(() => { order(); filter(); }));
  document.getElementById("unfold").addEventListener("click", () => fold(true));
  document.getElementById("fold").addEventListener("click", () => fold(false));
  document.getElementById("again").addEventListener("click", () => { reset(); search.focus(); });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const typing = event.target.matches?.("input[type=search], select, textarea");
    if (event.key === "Escape" && event.target === search) {
      search.value = "";
      search.blur();
      filter();
    } else if (typing) {
      return;
    } else if (event.key === "/") {
      event.preventDefault();
      search.focus();
    } else if (event.key === "j") {
      step(1);
    } else if (event.key === "k") {
      step(-1);
    }
  });
  let closed = [];
  addEventListener("beforeprint", () => {
    closed = [...document.querySelectorAll("details:not([open])")];
    closed.forEach((details) => { details.open = true; });
  });
  addEventListener("afterprint", () => closed.forEach((details) => { details.open = false; }));
  addEventListener("hashchange", follow);

  form.hidden = false;
  filter();
  follow();
})();
