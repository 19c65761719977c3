// The side of each page: the present page is marked, the search lists pages, a phone opens the contents by a button.
const here = decodeURIComponent(location.pathname.split("/").pop() || "index.html");
for (const link of document.querySelectorAll("#contents a")) {
  if (link.getAttribute("href") === here) {
    link.classList.add("here");
    link.setAttribute("aria-current", "page");
    if (matchMedia("(min-width: 60rem)").matches) link.scrollIntoView({ block: "center" });
  }
}
document.getElementById("menu").addEventListener("click", () =>
  document.getElementById("site").classList.toggle("open"));

// Every word of the search must occur in a page's name, title or names of checks; titles come first.
const search = document.getElementById("search"), found = document.getElementById("found");
const pages = talusPages.map(([name, title, words]) =>
  ({ name, title, head: (name + " " + title).toLowerCase(), all: (name + " " + title + " " + words).toLowerCase() }));
search.addEventListener("input", () => {
  const words = search.value.toLowerCase().split(/\s+/).filter(word => word !== "");
  found.replaceChildren();
  if (words.length === 0) return;
  const holds = text => words.every(word => text.includes(word));
  const hits = pages.filter(page => holds(page.all)).sort((a, b) => holds(b.head) - holds(a.head));
  for (const page of hits.slice(0, 20)) {
    const item = document.createElement("li"), link = document.createElement("a");
    link.href = page.name + ".html";
    link.textContent = page.title;
    item.append(link);
    found.append(item);
  }
  if (hits.length === 0) {
    const item = document.createElement("li");
    item.textContent = "No page holds all these words.";
    found.append(item);
  }
});
