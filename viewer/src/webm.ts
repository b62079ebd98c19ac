// A WebM file of one video track, put together in memory: the part of Matroska (RFC 9559) that a film needs.

/** A picture as the encoder left it. */
export interface EncodedFrame {
  data: Uint8Array;
  /** Whether it can be shown without those before it. */
  key: boolean;
}

export interface Film {
  width: number;
  height: number;
  codec: "V_VP8" | "V_VP9";
  framesPerSecond: number;
  frames: EncodedFrame[];
}

/** Elements by the names of RFC 9559. */
const ID = {
  EBML: 0x1a45dfa3,
  EBMLVersion: 0x4286,
  EBMLReadVersion: 0x42f7,
  EBMLMaxIDLength: 0x42f2,
  EBMLMaxSizeLength: 0x42f3,
  DocType: 0x4282,
  DocTypeVersion: 0x4287,
  DocTypeReadVersion: 0x4285,
  Segment: 0x18538067,
  Info: 0x1549a966,
  TimestampScale: 0x2ad7b1,
  Duration: 0x4489,
  MuxingApp: 0x4d80,
  WritingApp: 0x5741,
  Tracks: 0x1654ae6b,
  TrackEntry: 0xae,
  TrackNumber: 0xd7,
  TrackUID: 0x73c5,
  TrackType: 0x83,
  FlagLacing: 0x9c,
  CodecID: 0x86,
  DefaultDuration: 0x23e383,
  Video: 0xe0,
  PixelWidth: 0xb0,
  PixelHeight: 0xba,
  Cues: 0x1c53bb6b,
  CuePoint: 0xbb,
  CueTime: 0xb3,
  CueTrackPositions: 0xb7,
  CueTrack: 0xf7,
  CueClusterPosition: 0xf1,
  Cluster: 0x1f43b675,
  Timestamp: 0xe7,
  SimpleBlock: 0xa3,
} as const;

/** Within a cluster, times have 16 bits with a sign, ms. */
const LONGEST_CLUSTER = 30_000;

type Bytes = Uint8Array<ArrayBuffer>;

function joined(parts: Uint8Array[]): Bytes {
  const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

/** A whole number, the highest byte first; `least` bytes at least. */
function whole(value: number, least = 1): Bytes {
  const out: number[] = [];
  for (let rest = value; rest > 0 || out.length < least; rest = Math.floor(rest / 256)) out.unshift(rest % 256);
  return Uint8Array.from(out);
}

/** An element whose size has 8 bytes. */
function element(id: number, ...content: Uint8Array[]): Bytes {
  const size = whole(content.reduce((sum, part) => sum + part.length, 0), 8);
  size[0] = 0x01;
  return joined([whole(id), size, ...content]);
}

function number(id: number, value: number, least = 1): Bytes {
  return element(id, whole(value, least));
}

function text(id: number, value: string): Bytes {
  return element(id, new TextEncoder().encode(value));
}

function float(id: number, value: number): Bytes {
  const out = new Uint8Array(8);
  new DataView(out.buffer).setFloat64(0, value);
  return element(id, out);
}

/** Frames that are shown from `start` on, ms; the first one is whole. */
interface Cluster {
  start: number;
  bytes: Bytes;
}

function clusters(film: Film): Cluster[] {
  const time = (k: number) => Math.round((1000 * k) / film.framesPerSecond);
  const begins: number[] = [];
  film.frames.forEach((frame, k) => {
    const last = begins.at(-1);
    if (last === undefined || frame.key || time(k) - time(last) > LONGEST_CLUSTER) begins.push(k);
  });
  return begins.map((begin, i) => {
    const start = time(begin);
    const blocks = film.frames.slice(begin, begins[i + 1]).map((frame, k) => {
      const after = time(begin + k) - start;
      // Track 1, time after the cluster's, and whether it stands alone.
      const head = Uint8Array.from([0x81, after >> 8, after & 0xff, frame.key ? 0x80 : 0]);
      return element(ID.SimpleBlock, head, frame.data);
    });
    return { start, bytes: element(ID.Cluster, number(ID.Timestamp, start), ...blocks) };
  });
}

/** The file. Times are rounded to a millisecond, as the format counts them. */
export function webm(film: Film): Bytes {
  const { width, height, codec, framesPerSecond, frames } = film;
  const head = element(
    ID.EBML,
    number(ID.EBMLVersion, 1),
    number(ID.EBMLReadVersion, 1),
    number(ID.EBMLMaxIDLength, 4),
    number(ID.EBMLMaxSizeLength, 8),
    text(ID.DocType, "webm"),
    number(ID.DocTypeVersion, 4),
    number(ID.DocTypeReadVersion, 2),
  );
  const info = element(
    ID.Info,
    number(ID.TimestampScale, 1_000_000),
    float(ID.Duration, (1000 * frames.length) / framesPerSecond),
    text(ID.MuxingApp, "riprap"),
    text(ID.WritingApp, "riprap"),
  );
  const track = element(
    ID.TrackEntry,
    number(ID.TrackNumber, 1),
    number(ID.TrackUID, 1),
    number(ID.TrackType, 1),
    number(ID.FlagLacing, 0),
    text(ID.CodecID, codec),
    number(ID.DefaultDuration, Math.round(1e9 / framesPerSecond)),
    element(ID.Video, number(ID.PixelWidth, width), number(ID.PixelHeight, height)),
  );
  const before = joined([info, element(ID.Tracks, track)]);
  const all = clusters(film);
  // Where each cluster lies depends on the length of this table, which is the same for all places: they have 8 bytes.
  const cues = (places: number[]) =>
    element(
      ID.Cues,
      ...all.map(({ start }, i) =>
        element(
          ID.CuePoint,
          number(ID.CueTime, start),
          element(ID.CueTrackPositions, number(ID.CueTrack, 1), number(ID.CueClusterPosition, places[i]!, 8)),
        ),
      ),
    );
  let at = before.length + cues(all.map(() => 0)).length;
  const places = all.map(({ bytes }) => (at += bytes.length) - bytes.length);
  return joined([head, element(ID.Segment, before, cues(places), ...all.map((c) => c.bytes))]);
}
