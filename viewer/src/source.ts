// Where answers about a run come from: the server of `riprap view`, or the page itself in a report.

import { wordsOf, type Loading, type Waiting } from "./loading";
import { Packet } from "./wire";

/** Why something cannot be shown, in words for the person in front of the page. */
export class Problem extends Error {
  constructor(
    readonly what: string,
    readonly hint: string,
  ) {
    super(what);
  }
}

export interface Source {
  json<T>(question: string): Promise<T>;
  packet<T>(question: string): Promise<Packet<T>>;
  /** Address of a file of the run folder, if it can be had. */
  file(name: string): string | undefined;
}

/** Asks the server about one of its runs. */
export class Served implements Source {
  constructor(
    private readonly run: number,
    private readonly loading: Loading,
  ) {}

  json<T>(question: string): Promise<T> {
    return this.told(question, async (response) => (await response.json()) as T);
  }

  packet<T>(question: string): Promise<Packet<T>> {
    return this.told(question, async (response, waiting) => new Packet<T>(await bytesOf(response, waiting)));
  }

  /** Asks, and tells how far the answer has come. */
  private async told<T>(question: string, read: (response: Response, waiting: Waiting) => Promise<T>): Promise<T> {
    const waiting = this.loading.begin(wordsOf(question));
    try {
      return await read(await this.ask(question), waiting);
    } finally {
      this.loading.end(waiting);
    }
  }

  file(name: string): string {
    return `api/${this.run}/file/${name}`;
  }

  private async ask(question: string): Promise<Response> {
    let response: Response;
    try {
      response = await fetch(`api/${this.run}/${question}`);
    } catch {
      throw new Problem("The viewer does not answer any more.", "Start it again: riprap view RUN");
    }
    if (response.ok) return response;
    const told = (await response.json().catch(() => ({}))) as { what?: string; hint?: string };
    throw new Problem(told.what ?? `${question}: ${response.status}`, told.hint ?? "Reload the page.");
  }
}

/** The bytes of an answer, counted while they come where they are many. */
async function bytesOf(response: Response, waiting: Waiting): Promise<ArrayBuffer> {
  const length = Number(response.headers.get("content-length"));
  if (!response.body || !(length > 1e6)) return response.arrayBuffer();
  waiting.of = length;
  const all = new Uint8Array(length);
  const reader = response.body.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    all.set(value, waiting.got);
    waiting.got += value.length;
  }
  if (waiting.got !== length) throw new Problem("The answer of the viewer was cut off.", "Reload the page.");
  return all.buffer;
}

/** Answers that the page itself holds: gzip in base64 by question. */
export class Held implements Source {
  constructor(private readonly answers: Map<string, string | { as: string }>) {}

  async json<T>(question: string): Promise<T> {
    return JSON.parse(new TextDecoder().decode(await this.bytes(question))) as T;
  }

  async packet<T>(question: string): Promise<Packet<T>> {
    return new Packet<T>(await this.bytes(question));
  }

  file(): undefined {
    return undefined;
  }

  private async bytes(question: string): Promise<ArrayBuffer> {
    let text = this.answers.get(question);
    if (typeof text === "object") text = this.answers.get(text.as);
    if (typeof text !== "string") {
      throw new Problem("The report does not hold this.", "Look at the run itself: riprap view RUN");
    }
    const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
  }
}
