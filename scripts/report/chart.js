// Points on logarithmic axes; what a point is stands beside the pointer. `points`: {x, y, family, name,
// front}.
"use strict";

function chart(element, points, xName, yName) {
  const W = 760, H = 420, L = 60, B = 44, T = 16, R = 170;
  const colours = ["#1b6ca8", "#c44e1f", "#3a7d34", "#7b4fa0", "#8a6d1d", "#00838f", "#666"];
  const range = (of) => [Math.min(...of) / 1.4, Math.max(...of) * 1.4];
  const xs = range(points.map((p) => p.x)), ys = range(points.map((p) => p.y));
  const place = (v, [a, b], from, to) => from + ((to - from) * Math.log(v / a)) / Math.log(b / a);
  const x = (v) => place(v, xs, L, W - R), y = (v) => place(v, ys, H - B, T);
  const families = [...new Set(points.map((p) => p.family))];
  const parts = [];
  const ticks = (range, draw) => {
    const steps = range[1] < 1e3 * range[0] ? [1, 2, 5] : [1];
    for (let e = Math.floor(Math.log10(range[0])); 10 ** e <= range[1]; ++e)
      for (const step of steps) {
        const v = Number((step * 10 ** e).toPrecision(1));
        if (v >= range[0] && v <= range[1]) draw(v, e >= -2 && e <= 4 ? String(v) : `${step}e${e}`);
      }
  };
  ticks(xs, (v, word) => parts.push(`<line x1="${x(v)}" x2="${x(v)}" y1="${T}" y2="${H - B}" stroke="#ddd"/><text x="${x(v)}" y="${H - B + 16}" text-anchor="middle">${word}</text>`));
  ticks(ys, (v, word) => parts.push(`<line x1="${L}" x2="${W - R}" y1="${y(v)}" y2="${y(v)}" stroke="#ddd"/><text x="${L - 6}" y="${y(v) + 4}" text-anchor="end">${word}</text>`));
  parts.push(`<text x="${(L + W - R) / 2}" y="${H - 8}" text-anchor="middle">${xName}</text><text x="${L}" y="${T - 4}">${yName}</text>`);
  const front = points.filter((p) => p.front).sort((a, b) => a.x - b.x);
  parts.push(`<polyline fill="none" stroke="#555" stroke-dasharray="4 3" points="${front.map((p) => `${x(p.x)},${y(p.y)}`).join(" ")}"/>`);
  points.forEach((p, i) => {
    const colour = colours[families.indexOf(p.family) % colours.length];
    parts.push(`<circle data-i="${i}" cx="${x(p.x)}" cy="${y(p.y)}" r="5" stroke="${colour}" fill="${p.front ? colour : "#fff8"}"/>`);
  });
  families.forEach((family, i) => parts.push(`<circle cx="${W - R + 20}" cy="${T + 14 + 20 * i}" r="5" fill="none" stroke="${colours[i % colours.length]}"/><text x="${W - R + 32}" y="${T + 18 + 20 * i}">${family}</text>`));
  parts.push(`<text x="${W - R + 14}" y="${T + 24 + 20 * families.length}">filled: Pareto front</text>`);
  element.innerHTML = `<svg viewBox="0 0 ${W} ${H}" font-size="12" font-family="sans-serif">${parts.join("")}</svg><p class="tip">Point at a dot.</p>`;
  const tip = element.querySelector(".tip");
  element.querySelectorAll("circle[data-i]").forEach((dot) => {
    dot.addEventListener("pointerenter", () => {
      const p = points[dot.dataset.i];
      tip.textContent = `${p.name}: ${p.x.toPrecision(3)} ${xName}, ${p.y.toPrecision(3)} ${yName}`;
    });
  });
}
