//! Pictures one after the other in one file: animated PNG, which browsers, word processors and ffmpeg read.

use std::path::Path;

use resvg::tiny_skia::Pixmap;
use riprap_record::write_whole;

use super::super::PlotError;
use super::wanted::failed;

/// Writes pictures of one size, `rate` of them a second, shown again and again. After the first one a picture holds only the
/// rectangle in which it differs from that before it.
pub(super) fn write(
    out: &Path,
    count: usize,
    rate: f64,
    pictures: impl Iterator<Item = Result<Pixmap, PlotError>>,
) -> Result<(), PlotError> {
    let mut pictures = pictures.peekable();
    let size = match pictures.peek() {
        Some(Ok(first)) => [first.width(), first.height()],
        // What is wrong with it is told below.
        Some(Err(_)) | None => [1, 1],
    };
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size[0], size[1]);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_animated(count as u32, 0).map_err(failed)?;
    // A delay is a ratio of two numbers of 16 bits.
    encoder.set_frame_delay(1000, (1000.0 * rate).round().min(65535.0) as u16).map_err(failed)?;
    let mut writer = encoder.write_header().map_err(failed)?;
    let mut last: Option<Vec<u8>> = None;
    for picture in pictures {
        let points = rgb_of(&picture?);
        let [left, top, right, bottom] = match &last {
            Some(last) => changed(last, &points, size[0] as usize),
            None => [0, 0, size[0], size[1]],
        };
        if last.is_some() {
            writer.reset_frame_position().map_err(failed)?;
            writer.set_frame_dimension(right - left, bottom - top).map_err(failed)?;
            writer.set_frame_position(left, top).map_err(failed)?;
        }
        let row = |y: u32| {
            let from = 3 * (y * size[0] + left) as usize;
            &points[from..from + 3 * (right - left) as usize]
        };
        let part: Vec<u8> = (top..bottom).flat_map(row).copied().collect();
        writer.write_image_data(&part).map_err(failed)?;
        last = Some(points);
    }
    writer.finish().map_err(failed)?;
    Ok(write_whole(out, &bytes)?)
}

/// Red, green and blue of each point; pictures have no holes.
fn rgb_of(picture: &Pixmap) -> Vec<u8> {
    picture.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect()
}

/// Left, top, right and bottom of what differs, one point at least.
fn changed(a: &[u8], b: &[u8], wide: usize) -> [u32; 4] {
    let (mut low, mut high) = ([usize::MAX; 2], [0; 2]);
    for (at, _) in a.chunks_exact(3).zip(b.chunks_exact(3)).enumerate().filter(|(_, (a, b))| a != b)
    {
        for (k, v) in [at % wide, at / wide].into_iter().enumerate() {
            low[k] = low[k].min(v);
            high[k] = high[k].max(v + 1);
        }
    }
    if high[0] == 0 {
        return [0, 0, 1, 1];
    }
    [low[0], low[1], high[0], high[1]].map(|v| v as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use resvg::tiny_skia::Color;

    #[test]
    fn a_film_is_its_pictures_again() {
        let picture = |x: u32| {
            let mut map = Pixmap::new(8, 6).unwrap();
            map.fill(Color::WHITE);
            let blue = Color::from_rgba8(0, 0, 255, 255).premultiply().to_color_u8();
            map.pixels_mut()[(3 * 8 + x) as usize] = blue;
            Ok(map)
        };
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("a.apng");
        let places = [2, 5, 5];
        write(&out, 3, 12.5, places.into_iter().map(picture)).unwrap();
        let bytes = std::io::Cursor::new(std::fs::read(&out).unwrap());
        let mut reader = png::Decoder::new(bytes).read_info().unwrap();
        assert_eq!(reader.info().animation_control().unwrap().num_frames, 3);
        let mut shown = vec![0; 8 * 6 * 3];
        for x in places {
            let mut part = vec![0; 8 * 6 * 3];
            reader.next_frame(&mut part).unwrap();
            let frame = *reader.info().frame_control().unwrap();
            assert_eq!((frame.delay_num, frame.delay_den), (1000, 12500));
            for y in 0..frame.height {
                let to = 3 * ((frame.y_offset + y) * 8 + frame.x_offset) as usize;
                let from = 3 * (y * frame.width) as usize;
                let long = 3 * frame.width as usize;
                shown[to..to + long].copy_from_slice(&part[from..from + long]);
            }
            assert_eq!(shown, rgb_of(&picture(x).unwrap()), "{x}");
        }
    }
}
