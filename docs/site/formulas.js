// Sets the formulas that Sphinx leaves as \( … \) and \[ … \], and those that notebooks show between dollars.
// Without KaTeX they stay as they are.
const set = (formula, element, displayMode) =>
  window.katex?.render(formula, element, { displayMode, throwOnError: false, output: "html" });

for (const element of document.querySelectorAll(".math"))
  set(element.textContent.trim().replace(/^\\[([]|\\[)\]]$/g, ""), element, element.tagName === "DIV");

for (const output of document.querySelectorAll(".output.text_html")) {
  const texts = document.createTreeWalker(output, NodeFilter.SHOW_TEXT);
  const found = [];
  while (texts.nextNode()) if (/\$[^$]+\$/.test(texts.currentNode.data)) found.push(texts.currentNode);
  for (const text of found) {
    const parts = text.data.split("$").map((part, k) => {
      if (k % 2 === 0) return document.createTextNode(part);
      const span = document.createElement("span");
      set(part, span, false);
      return span;
    });
    text.replaceWith(...parts);
  }
}
