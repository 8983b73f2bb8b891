//! Rendered pictures with their cameras, as `nullcone texture` reads them.

use std::path::{Path, PathBuf};

use anyhow::Result;
use ga_camera::format::NamedCamera;
use ga_camera::format::json::{VIEWS, encode_views};
use ga_image::file::FormatError;
use ga_image::plane::Plane;
use ga_image::png;
use ga_render::View;

use crate::camera_file;

/// Pictures, and a file with their cameras, in one folder.
pub(crate) struct ViewFiles<'a> {
    folder: &'a Path,
    cameras: Vec<NamedCamera>,
    pictures: Vec<Result<Vec<u8>, FormatError>>,
}

/// The names of the files of this number of pictures.
pub(crate) fn names(pictures: u32) -> impl Iterator<Item = String> {
    let pictures = (0..pictures as usize).map(picture_name);
    pictures.chain([VIEWS.to_owned()])
}

fn picture_name(number: usize) -> String {
    format!("view-{number:03}.png")
}

impl<'a> ViewFiles<'a> {
    pub(crate) fn new(folder: &'a Path) -> Self {
        Self {
            folder,
            cameras: Vec::new(),
            pictures: Vec::new(),
        }
    }

    pub(crate) fn add(&mut self, picture: &Plane<[u8; 3]>, view: &View) -> Result<()> {
        let size = [picture.width(), picture.height()].map(|side| side as u32);
        let name = picture_name(self.cameras.len());
        let mut camera = camera_file::of_view(&name, view, size)?;
        camera.picture = Some(self.folder.join(name));
        self.cameras.push(camera);
        self.pictures.push(png::encode(picture));
        Ok(())
    }

    /// The paths and contents of the files.
    pub(crate) fn finish(self) -> Result<Vec<(PathBuf, Vec<u8>)>> {
        let mut files = Vec::with_capacity(self.pictures.len() + 1);
        let views = encode_views(&self.cameras, self.folder)?;
        for (camera, picture) in self.cameras.into_iter().zip(self.pictures) {
            files.extend(camera.picture.zip(Some(picture?)));
        }
        files.push((self.folder.join(VIEWS), views.into_bytes()));
        Ok(files)
    }
}
