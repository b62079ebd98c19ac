// Binary answers: a JSON head that lists typed arrays, then the arrays (crates/riprap-view/src/wire.rs).

type Numbers = Float32Array | Float64Array | Uint32Array | Int16Array | Uint8Array;

interface Entry {
  name: string;
  type: "f32" | "f64" | "u32" | "i16" | "u8";
  at: number;
  length: number;
}

const KINDS = { f32: Float32Array, f64: Float64Array, u32: Uint32Array, i16: Int16Array, u8: Uint8Array };

/** An answer taken apart. The arrays are views of its bytes. */
export class Packet<Info> {
  readonly info: Info;
  readonly bytes: number;
  private readonly arrays = new Map<string, Numbers>();

  constructor(buffer: ArrayBuffer) {
    const length = new DataView(buffer).getUint32(0, true);
    const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))) as {
      info: Info;
      arrays: Entry[];
    };
    this.info = head.info;
    this.bytes = buffer.byteLength;
    const body = Math.ceil((4 + length) / 8) * 8;
    for (const entry of head.arrays) {
      this.arrays.set(entry.name, new KINDS[entry.type](buffer, body + entry.at, entry.length));
    }
  }

  has(name: string): boolean {
    return this.arrays.has(name);
  }

  f32(name: string): Float32Array {
    return this.get(name) as Float32Array;
  }

  f64(name: string): Float64Array {
    return this.get(name) as Float64Array;
  }

  u32(name: string): Uint32Array {
    return this.get(name) as Uint32Array;
  }

  i16(name: string): Int16Array {
    return this.get(name) as Int16Array;
  }

  u8(name: string): Uint8Array {
    return this.get(name) as Uint8Array;
  }

  private get(name: string): Numbers {
    const found = this.arrays.get(name);
    if (!found) throw new Error(`the answer has no array ${name}`);
    return found;
  }
}
