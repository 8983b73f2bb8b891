//! Films as they are written.

use std::io::{BufWriter, Seek, SeekFrom, Write};
use std::path::Path;

use anyhow::{Context as _, Result, ensure};
use ga_image::film::{self, Rate};
use ga_image::plane::Plane;

use crate::files::Files;
use crate::format::Format;
use crate::frame::Warning;
use crate::output::Staging;

/// The formats of films.
pub(crate) const FORMATS: [Format; 3] = [Format::Png, Format::Y4m, Format::Mp4];

/// The format of a film that is to be written, as [`Files::write`] finds it.
pub(crate) fn format(files: &mut Files, option: &str, path: &Path) -> Result<Format> {
    let format = files.write(option, path, &FORMATS)?;
    let shown = path.display();
    let other = path.with_extension("y4m");
    ensure!(
        format != Format::Mp4 || cfg!(feature = "mp4"),
        "{option} {shown}: this program was built without the feature `mp4`, which cargo install \
         --path cli --features mp4 adds; without it, write {y4m} and let ffmpeg make the MP4: \
         ffmpeg -i {y4m} {shown}",
        y4m = other.display()
    );
    Ok(format)
}

/// A film that is to be written.
#[derive(Clone, Copy)]
pub(crate) struct Film<'a> {
    pub(crate) path: &'a Path,
    pub(crate) format: Format,
    /// Columns and rows.
    pub(crate) size: [u32; 2],
    pub(crate) frames: usize,
    pub(crate) rate: Rate,
}

/// What is given the pictures of a film one after the other.
pub(crate) type Show<'a> = dyn FnMut(&Plane<[u8; 3]>) -> Result<()> + 'a;

impl Film<'_> {
    /// Writes the film, whose pictures a function shows, and returns how many bytes it has.
    pub(crate) fn write(
        &self,
        outputs: &Staging,
        show: impl FnOnce(&mut Show<'_>) -> Result<()>,
    ) -> Result<usize> {
        let mut bytes = 0;
        outputs.write_with(self.path, |file| {
            let failed = || format!("cannot write {}", self.path.display());
            let mut file = BufWriter::new(file);
            let mut writer = Writer::new(&mut file, self).with_context(failed)?;
            show(&mut |picture| writer.write(picture).with_context(failed))?;
            writer.finish().with_context(failed)?;
            bytes = file.seek(SeekFrom::End(0)).with_context(failed)?;
            Ok(())
        })?;
        Ok(bytes as usize)
    }

    /// What of the pictures is not as it was drawn.
    pub(crate) fn warning(&self) -> Option<Warning> {
        let [width, height] = self.size;
        let even = self.size.map(|side| side.next_multiple_of(2));
        (self.format == Format::Mp4 && even != self.size).then(|| {
            let message = format!(
                "H.264 has an even number of columns and rows: {width} × {height} pixels become {} \
                 × {}, with the last ones repeated",
                even[0], even[1]
            );
            Warning::new("padded", message).in_file(self.path)
        })
    }
}

/// A film of any of the [`FORMATS`].
enum Writer<W: Write + Seek> {
    Plain(film::Writer<W>),
    #[cfg(feature = "mp4")]
    Mp4(Box<ga_video::mp4::Writer<W>>),
}

impl<W: Write + Seek> Writer<W> {
    fn new(file: W, film: &Film<'_>) -> Result<Self> {
        let size = film.size.map(|side| side as usize);
        let format = match film.format {
            #[cfg(feature = "mp4")]
            Format::Mp4 => {
                let writer = ga_video::mp4::Writer::new(file, size, film.frames, film.rate)?;
                return Ok(Self::Mp4(Box::new(writer)));
            }
            Format::Y4m => film::Format::Y4m,
            _ => film::Format::Png,
        };
        let writer = film::Writer::new(file, format, size, film.frames, film.rate)?;
        Ok(Self::Plain(writer))
    }

    fn write(&mut self, picture: &Plane<[u8; 3]>) -> Result<()> {
        match self {
            Self::Plain(writer) => Ok(writer.write(picture)?),
            #[cfg(feature = "mp4")]
            Self::Mp4(writer) => Ok(writer.write(picture)?),
        }
    }

    fn finish(self) -> Result<()> {
        match self {
            Self::Plain(writer) => Ok(writer.finish()?),
            #[cfg(feature = "mp4")]
            Self::Mp4(writer) => Ok(writer.finish()?),
        }
    }
}
