//! Writing a checkpoint: encoded, packed, summed and written as it goes, so that the state is never there a second time.

use std::fs::File;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::Path;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use postcard::ser_flavors::Flavor;
use serde::Serialize;

use super::super::disk::{OutputError, write_whole_with};
use super::behind::behind;
use super::stored::{BLOCK, Stored};
use super::sum::Sum;
use super::{FORMAT_VERSION, HEAD, KIND_BYTES, MAGIC, SUM_AT};

/// Bytes that are summed and written at once.
const PIECE: usize = 1 << 20;

/// Whether a checkpoint is to be small or to be there soon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// Compressed.
    Small,
    /// Not compressed: several times as large, in a fraction of the time. For someone who waits.
    Quick,
}

/// Encodes a state into the bytes of a checkpoint file.
///
/// # Errors
/// A value that postcard cannot encode, or a `kind` that is not 1 to 16 ASCII characters: both are mistakes of
/// the programmer, reported as `InvalidData`.
pub fn encode<T: Serialize>(kind: &str, value: &T) -> io::Result<Vec<u8>> {
    encode_as(kind, value, Packing::Small)
}

pub(super) fn encode_as<T: Serialize>(
    kind: &str,
    value: &T,
    packing: Packing,
) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let head = put(&mut bytes, kind, value, packing)?;
    bytes[..HEAD].copy_from_slice(&head);
    Ok(bytes)
}

/// Writes a checkpoint: aside, synced, renamed.
///
/// # Errors
/// Whatever the disk says.
pub fn write<T: Serialize>(path: &Path, kind: &str, value: &T) -> Result<(), OutputError> {
    write_as(path, kind, value, Packing::Small)
}

pub(super) fn write_as<T: Serialize>(
    path: &Path,
    kind: &str,
    value: &T,
    packing: Packing,
) -> Result<(), OutputError> {
    write_whole_with(path, |file: &mut File| {
        let head = behind(file, |file| put(file, kind, value, packing))?;
        file.seek(SeekFrom::Start(0))?;
        file.write_all(&head)
    })
}

/// Writes a checkpoint with zeros in place of the head, which is known last; the head.
pub(super) fn put<T: Serialize>(
    file: &mut impl Write,
    kind: &str,
    value: &T,
    packing: Packing,
) -> io::Result<Vec<u8>> {
    if kind.is_empty() || kind.len() > KIND_BYTES || !kind.is_ascii() {
        return Err(invalid(format!("checkpoint kind `{kind}` is not 1 to 16 ASCII characters")));
    }
    file.write_all(&[0; HEAD])?;
    let pieces = BufWriter::with_capacity(PIECE, Payload::new(&mut *file));
    let (plain, pieces) = match packing {
        Packing::Small => {
            let mut zlib = ZlibEncoder::new(pieces, Compression::fast());
            (plain(value, &mut zlib)?, zlib.finish()?)
        }
        Packing::Quick => {
            let mut zlib = Stored::new(pieces)?;
            (plain(value, &mut zlib)?, zlib.finish()?)
        }
    };
    let payload = pieces.into_inner().map_err(io::IntoInnerError::into_error)?;
    let mut head = Vec::with_capacity(HEAD);
    head.extend_from_slice(MAGIC);
    head.extend_from_slice(&FORMAT_VERSION.to_le_bytes());
    let mut padded = [0u8; KIND_BYTES];
    padded[..kind.len()].copy_from_slice(kind.as_bytes());
    head.extend_from_slice(&padded);
    head.extend_from_slice(&plain.to_le_bytes());
    head.extend_from_slice(&payload.bytes.to_le_bytes());
    let sum = payload.sum.finish(&head);
    head.extend_from_slice(&sum);
    Ok(head)
}

/// The sum of a head and of what follows it.
pub(super) fn checksum(head: &[u8], payload: &[u8]) -> [u8; 32] {
    let mut hasher = blake3::Hasher::new();
    hasher.update(head);
    hasher.update(payload);
    *hasher.finalize().as_bytes()
}

fn invalid(text: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, text)
}

/// What follows the head: counted and summed on its way.
struct Payload<W> {
    file: W,
    sum: Sum,
    bytes: u64,
}

impl<W> Payload<W> {
    fn new(file: W) -> Self {
        Self { file, sum: Sum::after(SUM_AT), bytes: 0 }
    }
}

impl<W: Write> Write for Payload<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes)?;
        // A file may take less than it is given, and gets the rest again.
        self.sum.update(&bytes[..written]);
        self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Encodes a value into `out`; its length.
fn plain<T: Serialize>(value: &T, out: &mut dyn Write) -> io::Result<u64> {
    let mut gathered = Gathered { block: Vec::with_capacity(BLOCK), out, bytes: 0, failed: None };
    let encoded = postcard::serialize_with_flavor(value, &mut gathered);
    // The encoder knows no errors of the disk.
    match (gathered.failed.take(), encoded) {
        (Some(error), _) => Err(error),
        (None, Err(error)) => Err(invalid(error.to_string())),
        (None, Ok(())) => {
            gathered.pass_on()?;
            Ok(gathered.bytes)
        }
    }
}

/// Gathers the numbers of a value, which come one by one, to blocks: a third of the time of `postcard::to_io`.
struct Gathered<'a> {
    block: Vec<u8>,
    out: &'a mut dyn Write,
    bytes: u64,
    failed: Option<io::Error>,
}

impl Gathered<'_> {
    fn pass_on(&mut self) -> io::Result<()> {
        self.out.write_all(&self.block)?;
        self.bytes += self.block.len() as u64;
        self.block.clear();
        Ok(())
    }

    /// Passes on the block and then `data`, for which there is no room in it.
    #[cold]
    fn overflow(&mut self, data: &[u8]) -> postcard::Result<()> {
        let mut rest = data;
        loop {
            if let Err(error) = self.pass_on() {
                self.failed = Some(error);
                return Err(postcard::Error::SerializeBufferFull);
            }
            let (now, later) = rest.split_at(rest.len().min(BLOCK));
            self.block.extend_from_slice(now);
            rest = later;
            if rest.is_empty() {
                return Ok(());
            }
        }
    }
}

impl Flavor for &mut Gathered<'_> {
    type Output = ();

    #[inline]
    fn try_extend(&mut self, data: &[u8]) -> postcard::Result<()> {
        if self.block.len() + data.len() > BLOCK {
            return self.overflow(data);
        }
        self.block.extend_from_slice(data);
        Ok(())
    }

    #[inline]
    fn try_push(&mut self, data: u8) -> postcard::Result<()> {
        self.try_extend(&[data])
    }

    fn finalize(self) -> postcard::Result<()> {
        Ok(())
    }
}
