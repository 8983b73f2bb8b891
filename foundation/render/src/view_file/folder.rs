use std::path::{Path, PathBuf};

use ga_camera::format::NamedCamera;
use ga_camera::format::json::{VIEWS, encode_views};
use ga_image::plane::Plane;
use ga_image::png;

use super::camera::to_camera;
use super::error::ViewFileError;
use crate::View;

/// Rendered pictures, and a file with their cameras, in one folder.
#[derive(Debug)]
pub struct ViewFiles<'a> {
    folder: &'a Path,
    cameras: Vec<NamedCamera>,
    files: Vec<(PathBuf, Vec<u8>)>,
}

/// The names of the files of this number of pictures.
pub fn names(pictures: u32) -> impl Iterator<Item = String> {
    let pictures = (0..pictures as usize).map(picture_name);
    pictures.chain([VIEWS.to_owned()])
}

fn picture_name(number: usize) -> String {
    format!("view-{number:03}.png")
}

impl<'a> ViewFiles<'a> {
    /// No pictures yet.
    #[must_use]
    pub fn new(folder: &'a Path) -> Self {
        Self {
            folder,
            cameras: Vec::new(),
            files: Vec::new(),
        }
    }

    /// Adds a picture and its view.
    ///
    /// # Errors
    ///
    /// [`ViewFileError::PictureCamera`] and [`ViewFileError::Picture`] for a picture without
    /// pixels.
    pub fn add(&mut self, picture: &Plane<[u8; 3]>, view: &View) -> Result<(), ViewFileError> {
        let size = [picture.width(), picture.height()].map(|side| side as u32);
        let name = picture_name(self.cameras.len());
        let path = self.folder.join(&name);
        let mut camera = to_camera(&name, view, size)?;
        camera.picture = Some(path.clone());
        self.cameras.push(camera);
        self.files.push((path, png::encode(picture)?));
        Ok(())
    }

    /// The paths and contents of the files, that of the cameras last.
    ///
    /// # Errors
    ///
    /// [`ViewFileError::Camera`] where the cameras cannot be written.
    pub fn finish(mut self) -> Result<Vec<(PathBuf, Vec<u8>)>, ViewFileError> {
        let views = encode_views(&self.cameras, self.folder)?;
        self.files
            .push((self.folder.join(VIEWS), views.into_bytes()));
        Ok(self.files)
    }
}
