// Where answers about a run come from: the server of `riprap view`, or the page itself in a report.

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
  constructor(private readonly run: number) {}

  async json<T>(question: string): Promise<T> {
    return (await (await this.ask(question)).json()) as T;
  }

  async packet<T>(question: string): Promise<Packet<T>> {
    return new Packet<T>(await (await this.ask(question)).arrayBuffer());
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
