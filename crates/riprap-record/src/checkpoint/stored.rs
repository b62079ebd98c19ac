//! A zlib stream of blocks that are stored as they are (RFC 1950, RFC 1951 section 3.2.4).
//!
//! `flate2` at level 0 makes such a stream too, but byte by byte: it takes longer than to compress.

use std::io::{self, Write};

use simd_adler32::Adler32;

/// Most bytes of a stored block: its length has 16 bits.
pub(super) const BLOCK: usize = 65_535;
/// 32 KiB window, no dictionary, fastest level: what every zlib stream begins with that was made in a hurry.
const BEGIN: [u8; 2] = [0x78, 0x01];
/// A last block, without bytes.
const END: [u8; 5] = [1, 0, 0, 0xff, 0xff];

pub(super) struct Stored<W> {
    out: W,
    sum: Adler32,
}

impl<W: Write> Stored<W> {
    pub(super) fn new(mut out: W) -> io::Result<Self> {
        out.write_all(&BEGIN)?;
        Ok(Self { out, sum: Adler32::new() })
    }

    /// Ends the stream.
    pub(super) fn finish(mut self) -> io::Result<W> {
        self.out.write_all(&END)?;
        self.out.write_all(&self.sum.finish().to_be_bytes())?;
        Ok(self.out)
    }
}

impl<W: Write> Write for Stored<W> {
    /// Each write is a block.
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let bytes = &bytes[..bytes.len().min(BLOCK)];
        let length = bytes.len() as u16;
        self.out.write_all(&[0])?;
        self.out.write_all(&length.to_le_bytes())?;
        self.out.write_all(&(!length).to_le_bytes())?;
        self.out.write_all(bytes)?;
        self.sum.write(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}
