// Makes a player of every film: points drawn on a canvas over the same axes as the still frames beside it.
"use strict";
(() => {
  const words = (text) => {
    const bytes = atob(text), buffer = new Uint8Array(bytes.length);
    for (let i = 0; i < bytes.length; i++) buffer[i] = bytes.charCodeAt(i);
    return new Uint16Array(buffer.buffer);  // little-endian, as every machine that runs a browser
  };
  const made = (parent, name, properties) => Object.assign(parent.appendChild(document.createElement(name)), properties);

  class Player {
    constructor(figure) {
      this.data = JSON.parse(figure.querySelector(".film-data").textContent);
      this.source = figure.querySelector(".film-values");
      this.box = figure.querySelector(".player");
      this.box.hidden = false;
      this.stage = this.box.querySelector(".stage");
      this.frame = 0;
      this.channel = 2;
      this.canvas = made(this.stage, "canvas", {});
      this.canvas.setAttribute("aria-hidden", "true");
      this.controls();
      new ResizeObserver(() => this.draw()).observe(this.stage);
      this.colour(2);
    }

    controls() {
      const row = document.createElement("div");
      row.className = "controls";
      this.stage.after(row);
      this.button = made(row, "button", {type: "button", className: "play", textContent: "play"});
      this.slider = made(row, "input", {type: "range", min: 0, max: this.data.frames.length - 1, step: 1, value: 0});
      this.slider.setAttribute("aria-label", "moment");
      this.time = made(row, "output", {});
      this.button.addEventListener("click", () => this.playing ? this.pause() : this.play());
      this.slider.addEventListener("input", () => { this.pause(); this.show(Number(this.slider.value)); });
      if (this.data.channels.length < 4) return;
      const choice = made(made(row, "label", {textContent: "colour "}), "select", {});
      this.data.channels.forEach((channel, c) => c < 2 || made(choice, "option", {value: c, textContent: channel.name}));
      choice.addEventListener("change", () => this.colour(Number(choice.value)));
    }

    colour(channel) {
      this.channel = channel;
      for (const scale of this.box.querySelectorAll(".scale")) scale.hidden = Number(scale.dataset.channel) !== channel;
      this.show(this.frame);
    }

    // Eight seconds for all frames, but no more than thirty a second.
    play() {
      if (this.frame + 1 >= this.data.frames.length) this.show(0);
      this.button.textContent = "pause";
      this.playing = setInterval(() => {
        if (this.frame + 1 >= this.data.frames.length) return this.pause();
        this.show(this.frame + 1);
      }, Math.max(33, 8000 / this.data.frames.length));
    }

    pause() {
      clearInterval(this.playing);
      this.playing = null;
      this.button.textContent = "play";
    }

    show(frame) {
      this.frame = frame;
      this.slider.value = frame;
      this.time.textContent = this.data.frames[frame];
      this.draw();
    }

    // Band of a stored number: limits are few, so the numbers are looked up once per channel.
    bands(channel) {
      channel.limit = channel.limit || channel.limits.slice(1, -1).map(
        (v) => (v - channel.from) / (channel.to - channel.from) * 65535);
      return channel.limit;
    }

    draw() {
      const [wide, high] = this.data.size, ratio = window.devicePixelRatio || 1, width = this.stage.clientWidth;
      if (!width) return;
      this.values = this.values || words(this.source.textContent);
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(width * high / wide * ratio);
      const pen = this.canvas.getContext("2d"), n = this.data.points, channels = this.data.channels;
      const start = this.frame * channels.length * n, scale = this.canvas.width / wide;
      const [x0, y0, metre] = this.data.place, [cx, cy] = channels, shown = channels[this.channel];
      const limits = this.bands(shown), dot = Math.max(1.2 * ratio, this.data.dot * scale);
      const ax = (x0 + cx.from * metre) * scale, bx = (cx.to - cx.from) * metre * scale / 65535;
      const ay = (y0 - cy.from * metre) * scale, by = (cy.to - cy.from) * metre * scale / 65535;
      const at = start + this.channel * n;
      let last = -1;
      for (let p = 0; p < n; p++) {
        const v = this.values[at + p];
        let band = 0;
        while (band < limits.length && v >= limits[band]) band++;
        if (band !== last) pen.fillStyle = shown.colours[last = band];
        pen.fillRect(ax + bx * this.values[start + p] - dot / 2, ay - by * this.values[start + n + p] - dot / 2, dot, dot);
      }
    }
  }

  for (const figure of document.querySelectorAll("figure.film")) new Player(figure);
})();
