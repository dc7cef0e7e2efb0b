// Everything is put together here. Without it the page is whole, but still.

function goToPlace() {
  const target = place && document.getElementById(decodeURIComponent(place));
  if (target && location.hash.includes("?")) target.scrollIntoView();
}

function start() {
  readAddress();
  document.documentElement.classList.add("live");
  document.body.append(said, tip);
  viewBar();
  const near = new IntersectionObserver((found) => {
    for (const one of found) {
      if (!one.isIntersecting) continue;
      near.unobserve(one.target);
      dress(one.target);
    }
  }, { rootMargin: "800px" });
  for (const table of tables) near.observe(table);
  for (const id of Object.keys(data.figures)) {
    const element = document.getElementById(id);
    if (element && id !== "answer-figure") dressDrawn(element, id === "time-against-error");
  }
  if (data.answer) showAnswer();
  goToPlace();
}

// Sections between here and there get their height only when they are first drawn, which moves the place: so the page goes there
// again whenever its height changes, until the reader moves on.
const arrive = new ResizeObserver(() => document.getElementById(decodeURIComponent(place))?.scrollIntoView());
let arrived;
for (const move of ["wheel", "touchmove", "keydown", "pointerdown"]) addEventListener(move, () => arrive.disconnect());

addEventListener("hashchange", () => {
  if (!location.hash.includes("?")) {
    place = location.hash.slice(1);
    const query = new URLSearchParams([...state]).toString();
    if (query) history.replaceState(null, "", `#${place}?${query}`);
    arrive.disconnect(); // so that it begins again
    arrive.observe(document.querySelector("main"));
    clearTimeout(arrived);
    arrived = setTimeout(() => arrive.disconnect(), 3000);
  } else {
    location.reload();
  }
});
start();
