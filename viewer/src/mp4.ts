// An MP4 file of one video track, put together in memory.

/*! mp4-muxer 5.2.2, Copyright (c) 2023 Vanilagy, MIT License */

import { ArrayBufferTarget, Muxer } from "mp4-muxer";
import type { EncodedFrame } from "./webm";

export interface Mp4Film {
  width: number;
  height: number;
  codec: "avc" | "vp9" | "av1";
  framesPerSecond: number;
  frames: EncodedFrame[];
  /** What the encoder says of its stream: H.264 cannot be read without. */
  decoder: VideoDecoderConfig;
}

/** The file, its table of frames before them, so that players need not wait for its end. */
export function mp4(film: Mp4Film): Uint8Array<ArrayBuffer> {
  const { width, height, codec, framesPerSecond, frames, decoder } = film;
  const target = new ArrayBufferTarget();
  const muxer = new Muxer({ target, video: { codec, width, height, frameRate: framesPerSecond }, fastStart: "in-memory" });
  const time = (k: number) => Math.round((1e6 * k) / framesPerSecond);
  frames.forEach(({ data, key }, k) => muxer.addVideoChunkRaw(data, key ? "key" : "delta", time(k), time(k + 1) - time(k), { decoderConfig: decoder }));
  muxer.finalize();
  return new Uint8Array(target.buffer);
}
