// SPDX-License-Identifier: MIT
// Answers batches of questions: a line of JSON {problem, degree, items} from standard input, a line of answers to standard output.
// An item is the coordinates x0, y0, x1, ... and then the question. An answer that fails or is not a number is null.
import { createInterface } from "node:readline";

export async function serve(answers) {
  for await (const line of createInterface({ input: process.stdin })) {
    const { problem, degree, items } = JSON.parse(line);
    const size = 2 * (degree + 1);
    console.log(JSON.stringify(items.map((item) => {
      try {
        return answers[problem](item.slice(0, size), item.slice(size));
      } catch {
        return null;
      }
    })));
  }
}
