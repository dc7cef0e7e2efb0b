// SPDX-License-Identifier: MIT
// The library in a worker, so that the page never waits for it. Of each kind of question only the newest is answered.

import { byId } from "./dom.mjs";

export class Engine {
  constructor(onFault) {
    this.waiting = new Map(); // kind -> the question that the worker has, and the newest one behind it
    this.number = 0;
    // The page holds the worker and the library as text, because browsers fetch nothing from a folder.
    const script = new Blob([byId("worker-script").textContent], { type: "text/javascript" });
    const worker = this.worker = new Worker(URL.createObjectURL(script));
    const fail = (why) => onFault(`The methods did not load (${why}); reload the page, or open it in a newer browser.`);
    worker.onerror = (event) => { event.preventDefault(); fail(event.message); };
    worker.onmessage = ({ data }) => { if (data.fatal) fail(data.fatal); else this.take(data); };
    worker.postMessage({ program: byId("program").textContent });
  }

  // `answered` gets (answer, fault), for slices several times.
  ask(kind, question, answered) {
    const now = this.waiting.get(kind);
    const next = { question, answered };
    if (now && kind !== "shares") now.next = next;
    else this.send(kind, next); // the slices of shares end when a newer question arrives
  }

  send(kind, one) {
    this.number += 1;
    this.waiting.set(kind, { ...one, number: this.number });
    this.worker.postMessage({ kind, number: this.number, question: one.question });
  }

  take({ kind, number, answer, fault, last }) {
    const now = this.waiting.get(kind);
    if (now?.number !== number) return;
    now.answered(answer, fault);
    if (!last) return;
    this.waiting.delete(kind);
    if (now.next) this.send(kind, now.next);
  }
}
