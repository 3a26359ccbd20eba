// Adds to the static figures what a script can: the nearest value under the pointer, zoom by dragging, and axes that
// change between linear and logarithmic.
// Without it every figure is still complete. The drawing's geometry and the data come with each figure as JSON.
"use strict";
(() => {
  const SVG = "http://www.w3.org/2000/svg";
  const element = (name, attributes, text) => {
    const node = document.createElementNS(SVG, name);
    for (const key in attributes) node.setAttribute(key, attributes[key]);
    if (text !== undefined) node.textContent = text;
    return node;
  };

  // Value -> pixel along one axis (and back), linear or logarithmic.
  const scale = (axis, start, end) => {
    const f = axis.log ? Math.log : (v) => v, g = axis.log ? Math.exp : (v) => v;
    const a = f(axis.from), b = f(axis.to);
    return {
      pixel: (v) => start + (f(v) - a) / (b - a) * (end - start),
      value: (p) => g(a + (p - start) / (end - start) * (b - a)),
    };
  };

  const number = (v) => {
    if (v === 0) return "0";
    const size = Math.abs(v);
    if (size >= 1e-3 && size < 1e6) return String(Number(v.toPrecision(5))).replace("-", "\u2212");
    const [mantissa, exponent] = v.toExponential(3).split("e");
    const raised = exponent.replace("+", "").replace(/[-\d]/g, (c) => c === "-" ? "\u207b" : "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[c]);
    return (Number(mantissa) + " \u00d7 10" + raised).replace("-", "\u2212");
  };

  const ticks = (axis) => {
    const decades = [];
    if (axis.log) for (let e = Math.ceil(Math.log10(axis.from) - 1e-9); 10 ** e <= axis.to * (1 + 1e-9); e++) decades.push(Number((10 ** e).toPrecision(1)));
    if (decades.length > 1) return decades.filter((_, i) => i % Math.ceil(decades.length / 8) === 0);
    const span = axis.to - axis.from, raw = span / 5, power = 10 ** Math.floor(Math.log10(raw)), m = raw / power;
    const step = power * (m < 1.5 ? 1 : m < 3.5 ? 2 : m < 7.5 ? 5 : 10), list = [];
    for (let i = Math.ceil(axis.from / step); i * step <= axis.to; i++) list.push(Number((i * step).toPrecision(12)));
    return list;
  };

  class Plot {
    constructor(figure) {
      this.figure = figure;
      this.svg = figure.querySelector("svg");
      this.data = JSON.parse(figure.querySelector("script").textContent);
      this.over = this.svg.appendChild(element("g", {class: "overlay"}));
      this.view(this.data.x, this.data.y);
      this.svg.classList.add("zoomable");
      this.svg.addEventListener("pointermove", (e) => this.move(e));
      this.svg.addEventListener("pointerleave", () => this.clear());
      this.svg.addEventListener("pointerdown", (e) => this.press(e));
      this.svg.addEventListener("pointerup", (e) => this.release(e));
      this.svg.addEventListener("dblclick", () => this.reset());
      this.kinds = ["x", "y"].map((a) => this.kindButton(a)).filter((button) => button);
    }

    // Where values span a decade, or the axis is logarithmic already, one may choose its kind.
    kindButton(a) {
      const [from, to] = this.range(a, true), row = this.figure.querySelector(".files");
      if (!row || !(to / from >= 10)) return null;
      const button = document.createElement("button");
      button.className = "axis-kind";
      button.dataset.axis = a;
      button.addEventListener("click", () => this.changeKind(a));
      this.name(button, this.data[a].log);
      row.append(button);
      return button;
    }

    name(button, log) {
      button.textContent = `${button.dataset.axis}: ${log ? "log" : "linear"}`;
      button.title = `show a ${log ? "linear" : "logarithmic"} axis`;
    }

    // Of what is drawn: all of it, or what a logarithm has.
    range(a, positive) {
      const values = this.data.series.flatMap((s) => s[a]).filter((v) => v !== null && (!positive || v > 0));
      return [values.reduce((u, v) => Math.min(u, v), Infinity), values.reduce((u, v) => Math.max(u, v), -Infinity)];
    }

    // The drawn axis, logarithmic instead of linear or the other way round, with a little room at both ends.
    otherKind(a) {
      const log = !this.data[a].log, [from, to] = this.range(a, log), margin = 0.03;
      const room = log ? (to / from) ** margin : margin * (to - from);
      return {...this.data[a], log, from: log ? from / room : from - room, to: log ? to * room : to + room};
    }

    changeKind(a) {
      const log = !this[a].log, own = this.data[a];
      const axis = own.log === log ? own : this.otherKind(a);
      this.clear();
      this.view(a === "x" ? axis : this.x, a === "y" ? axis : this.y);
      if (this.x === this.data.x && this.y === this.data.y) return this.reset();
      this.redraw();
      this.name(this.kinds.find((button) => button.dataset.axis === a), log);
    }

    view(x, y) {
      const [left, top, right, bottom] = this.data.box;
      this.x = x; this.y = y;
      this.px = scale(x, left, right);
      this.py = scale(y, bottom, top);
    }

    at(event) {
      const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
      const [left, top, right, bottom] = this.data.box;
      return {x: p.x, y: p.y, inside: p.x >= left - 8 && p.x <= right + 8 && p.y >= top - 8 && p.y <= bottom + 8};
    }

    nearest(p) {
      const [left, top, right, bottom] = this.data.box;
      let best = null, distance = 40 ** 2;
      for (const series of this.data.series)
        for (let i = 0; i < series.x.length; i++) {
          if (series.x[i] === null || series.y[i] === null) continue;
          const x = this.px.pixel(series.x[i]), y = this.py.pixel(series.y[i]);
          if (!(x >= left - 1 && x <= right + 1 && y >= top - 1 && y <= bottom + 1)) continue;
          const d = (x - p.x) ** 2 + (y - p.y) ** 2;
          if (d < distance || (best && d === distance && !best.series.label)) { distance = d; best = {series, i, x, y}; }
        }
      return best;
    }

    move(event) {
      const p = this.at(event);
      this.clear();
      if (this.start) {
        const x = Math.min(p.x, this.start.x), y = Math.min(p.y, this.start.y);
        this.mark = this.over.appendChild(element("rect", {x, y, width: Math.abs(p.x - this.start.x),
          height: Math.abs(p.y - this.start.y), fill: "#0072b2", "fill-opacity": 0.1, stroke: "#0072b2"}));
        return;
      }
      const hit = p.inside && this.nearest(p);
      if (!hit) return;
      this.mark = this.over.appendChild(element("circle", {cx: hit.x, cy: hit.y, r: 6, fill: "none",
        stroke: hit.series.colour, "stroke-width": 2}));
      this.tip = document.createElement("div");
      this.tip.className = "tip";
      const line = (axis, v) => axis.label + " " + number(v) + (axis.unit ? "\u00a0" + axis.unit : "");
      const name = this.tip.appendChild(document.createElement("b"));
      name.textContent = hit.series.label;
      for (const text of [line(this.data.x, hit.series.x[hit.i]), line(this.data.y, hit.series.y[hit.i])]) {
        this.tip.appendChild(document.createElement("br"));
        this.tip.append(text);
      }
      this.figure.append(this.tip);
      const frame = this.figure.getBoundingClientRect(), ring = this.mark.getBoundingClientRect();
      const flip = ring.right + this.tip.offsetWidth + 12 > frame.right;
      this.tip.style.left = (flip ? ring.left - frame.left - this.tip.offsetWidth - 6 : ring.right - frame.left + 6) + "px";
      this.tip.style.top = Math.max(0, ring.top - frame.top - this.tip.offsetHeight / 2) + "px";
    }

    clear() {
      if (this.mark) this.mark.remove();
      if (this.tip) this.tip.remove();
      this.mark = this.tip = null;
    }

    press(event) {
      const p = this.at(event);
      if (event.button !== 0 || event.pointerType === "touch" || !p.inside) return;
      event.preventDefault();
      this.start = p;
      this.svg.setPointerCapture(event.pointerId);
    }

    release(event) {
      const a = this.start, p = this.at(event);
      this.start = null;
      this.clear();
      if (!a || Math.abs(p.x - a.x) < 8 || Math.abs(p.y - a.y) < 8) return;
      const [left, top, right, bottom] = this.data.box, clamp = (v, lo, hi) => Math.min(hi, Math.max(lo, v));
      const part = (axis, s, u, v) => ({...axis, from: s.value(u), to: s.value(v)});
      const xs = [p.x, a.x].map((v) => clamp(v, left, right)).sort((u, v) => u - v);
      const ys = [p.y, a.y].map((v) => clamp(v, top, bottom)).sort((u, v) => u - v);
      const x = part(this.x, this.px, xs[0], xs[1]), y = part(this.y, this.py, ys[1], ys[0]);
      this.view(x, y);
      this.redraw();
    }

    reset() {
      this.view(this.data.x, this.data.y);
      if (this.zoomed) this.zoomed.remove();
      if (this.button) this.button.remove();
      this.zoomed = this.button = null;
      for (const button of this.kinds) this.name(button, this.data[button.dataset.axis].log);
      if (this.own && this.own !== this.data && this.data.x.unit + this.data.y.unit !== this.own.x.unit + this.own.y.unit)
        this.redraw();
    }

    // Pressures as metres of water of so many kPa each; 0: as they are.
    inHead(weight) {
      const own = this.own = this.own || this.data, factor = {};
      for (const a of ["x", "y"]) factor[a] = weight && own[a].unit === "kPa" ? 1 / weight : 1;
      if (factor.x === 1 && factor.y === 1 && own === this.data) return;
      const axis = (a) => factor[a] === 1 ? own[a]
        : {...own[a], from: own[a].from * factor[a], to: own[a].to * factor[a], unit: "m"};
      const scaled = (values, a) => factor[a] === 1 ? values : values.map((v) => v === null ? null : v * factor[a]);
      this.data = {...own, x: axis("x"), y: axis("y"),
        series: own.series.map((s) => ({...s, x: scaled(s.x, "x"), y: scaled(s.y, "y")}))};
      for (const text of this.svg.querySelectorAll("text")) {
        const plain = text.textContent;
        if (!this.zoomed?.contains(text) && /\[(kPa|m of water)\]/.test(plain))
          this.rename(text, weight ? /\[kPa\]/ : /\[m of water\]/, weight ? "[m of water]" : "[kPa]");
      }
      this.clear();
      this.reset();
    }

    // Only the leaf that holds the unit, so that gnuplot's spans stay.
    rename(text, from, to) {
      const walk = document.createTreeWalker(text, NodeFilter.SHOW_TEXT);
      for (let node = walk.nextNode(); node; node = walk.nextNode()) node.data = node.data.replace(from, to);
    }

    // The static plot is covered by one of the chosen part, with axes of its own.
    redraw() {
      if (this.zoomed) this.zoomed.remove();
      const [left, top, right, bottom] = this.data.box, clip = this.figure.id + "-clip";
      const g = this.zoomed = this.svg.insertBefore(element("g", {class: "zoomed", "font-size": 12}), this.over);
      g.append(element("rect", {x: left - 56, y: top - 8, width: right - left + 74, height: bottom - top + 34, fill: "#fff"}));
      const clipping = g.appendChild(element("clipPath", {id: clip}));
      clipping.append(element("rect", {x: left, y: top, width: right - left, height: bottom - top}));
      for (const v of ticks(this.x)) {
        const x = this.px.pixel(v);
        g.append(element("path", {d: `M${x} ${top}V${bottom}`, stroke: "#e4e4e4"}),
          element("text", {x, y: bottom + 17, "text-anchor": "middle", fill: "#333"}, number(v)));
      }
      for (const v of ticks(this.y)) {
        const y = this.py.pixel(v);
        g.append(element("path", {d: `M${left} ${y}H${right}`, stroke: "#e4e4e4"}),
          element("text", {x: left - 7, y: y + 4, "text-anchor": "end", fill: "#333"}, number(v)));
      }
      g.append(element("path", {d: `M${left} ${top}V${bottom}H${right}`, stroke: "#555", fill: "none"}));
      const marks = g.appendChild(element("g", {"clip-path": `url(#${clip})`}));
      for (const s of this.data.series) this.draw(marks, s);
      if (this.button || (this.x === this.data.x && this.y === this.data.y)) return;
      this.button = this.figure.appendChild(document.createElement("button"));
      this.button.className = "back";
      this.button.textContent = "whole figure";
      this.button.addEventListener("click", () => this.reset());
    }

    draw(group, series) {
      let path = "", pen = "M";
      for (let i = 0; i < series.x.length; i++) {
        const x = series.x[i] === null ? NaN : this.px.pixel(series.x[i]);
        const y = series.y[i] === null ? NaN : this.py.pixel(series.y[i]);
        if (!Number.isFinite(x) || !Number.isFinite(y)) { pen = "M"; continue; }
        if (series.style === "points")
          group.append(element("use", {href: series.mark, transform: `translate(${x},${y}) scale(3.15)`,
            color: series.colour, fill: "none"}));
        else path += pen + x.toFixed(2) + " " + y.toFixed(2);
        pen = "L";
      }
      if (path) group.append(element("path", {d: path, fill: "none", stroke: series.colour, "stroke-width": 1.8,
        "stroke-dasharray": series.style === "dashed" ? "7 4" : "none"}));
    }
  }

  const plots = [...document.querySelectorAll("figure")].filter((figure) => figure.querySelector(":scope > svg"))
    .map((figure) => new Plot(figure));

  // The style sheet changes legends from kPa to metres of water; line figures are drawn anew.
  const units = document.querySelector(".units");
  if (!units) return;
  const weight = Number(units.dataset.kpaPerMetre);
  const change = () => plots.forEach((plot) => plot.inHead(document.getElementById("in-metres").checked ? weight : 0));
  units.addEventListener("change", change);
  change();  // a browser may remember the choice
})();
