//! Rendered pictures with their cameras, as `nullcone texture` reads them.

use std::path::{Path, PathBuf};

use anyhow::Result;
use ga_image::file::FormatError;
use ga_image::plane::Plane;
use ga_image::png;
use ga_render::Camera;
use serde::Serialize;

use crate::camera_file::CameraFile;

/// The name of the file with the cameras.
const NAME: &str = ga_camera::format::views::FILE_NAME;

/// Pictures, and a file with their cameras, in one folder.
pub(crate) struct ViewFiles<'a> {
    folder: &'a Path,
    entries: Vec<Entry>,
    pictures: Vec<Result<Vec<u8>, FormatError>>,
}

/// A view in the file.
#[derive(Serialize)]
struct Entry {
    picture: String,
    camera: CameraFile,
}

/// The contents of the file.
#[derive(Serialize)]
struct Views {
    views: Vec<Entry>,
}

/// The names of the files of this number of pictures.
pub(crate) fn names(pictures: u32) -> impl Iterator<Item = String> {
    let pictures = (0..pictures as usize).map(picture_name);
    pictures.chain([NAME.to_owned()])
}

fn picture_name(number: usize) -> String {
    format!("view-{number:03}.png")
}

impl<'a> ViewFiles<'a> {
    pub(crate) fn new(folder: &'a Path) -> Self {
        Self {
            folder,
            entries: Vec::new(),
            pictures: Vec::new(),
        }
    }

    pub(crate) fn add(&mut self, picture: &Plane<[u8; 3]>, camera: &Camera) {
        let size = [picture.width(), picture.height()].map(|side| side as u32);
        self.entries.push(Entry {
            picture: picture_name(self.entries.len()),
            camera: CameraFile::new(camera, size),
        });
        self.pictures.push(png::encode(picture));
    }

    /// The paths and contents of the files.
    pub(crate) fn finish(self) -> Result<Vec<(PathBuf, Vec<u8>)>> {
        let mut files = Vec::with_capacity(self.pictures.len() + 1);
        for (entry, picture) in self.entries.iter().zip(self.pictures) {
            files.push((self.folder.join(&entry.picture), picture?));
        }
        let views = Views {
            views: self.entries,
        };
        files.push((self.folder.join(NAME), serde_json::to_vec_pretty(&views)?));
        Ok(files)
    }
}
