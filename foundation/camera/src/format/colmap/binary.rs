//! Models of COLMAP as binary files: numbers in the order of little-endian machines.

use super::device::{Device, Shot, distinct};
use super::model;
use super::text::pose;
use crate::format::error::{CameraFileError, Place};
use crate::format::fields::pixels;

/// The bytes of a file, of which some are read.
struct Bytes<'a> {
    all: &'a [u8],
    read: usize,
    format: &'static str,
}

impl<'a> Bytes<'a> {
    fn new(all: &'a [u8], format: &'static str) -> Self {
        Self {
            all,
            read: 0,
            format,
        }
    }

    fn refuse(&self, problem: &'static str) -> CameraFileError {
        CameraFileError::Binary {
            byte: self.read,
            format: self.format,
            problem,
        }
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N], CameraFileError> {
        let rest = self.all.get(self.read..).unwrap_or_default();
        let Some(found) = rest.first_chunk::<N>() else {
            return Err(self.refuse("it ends here, within a value"));
        };
        self.read += N;
        Ok(*found)
    }

    fn count(&mut self) -> Result<u64, CameraFileError> {
        self.take().map(u64::from_le_bytes)
    }

    fn number(&mut self) -> Result<f64, CameraFileError> {
        let number = f64::from_le_bytes(self.take()?);
        match number.is_finite() {
            true => Ok(number),
            false => Err(self.refuse("a number before this is not finite")),
        }
    }

    fn numbers<const N: usize>(&mut self) -> Result<[f64; N], CameraFileError> {
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            *number = self.number()?;
        }
        Ok(numbers)
    }

    fn skip(&mut self, count: u64, size: u64) -> Result<(), CameraFileError> {
        let bytes = count
            .checked_mul(size)
            .and_then(|x| usize::try_from(x).ok());
        let end = bytes.and_then(|bytes| self.read.checked_add(bytes));
        match end.filter(|end| *end <= self.all.len()) {
            Some(end) => self.read = end,
            None => return Err(self.refuse("it ends within the points that begin here")),
        }
        Ok(())
    }

    /// A text that a null byte ends.
    fn text(&mut self) -> Result<String, CameraFileError> {
        let rest = self.all.get(self.read..).unwrap_or_default();
        let Some(end) = rest.iter().position(|byte| *byte == 0) else {
            return Err(self.refuse("a name that begins here does not end"));
        };
        let text = std::str::from_utf8(&rest[..end]);
        let text = text.map_err(|_| self.refuse("a name that begins here is not text"))?;
        self.read += end + 1;
        Ok(text.to_owned())
    }

    fn end(&self) -> Result<(), CameraFileError> {
        match self.read == self.all.len() {
            true => Ok(()),
            false => Err(self.refuse("more bytes follow than it announces")),
        }
    }
}

pub(super) fn devices(bytes: &[u8]) -> Result<Vec<Device>, CameraFileError> {
    let mut bytes = Bytes::new(bytes, "COLMAP's cameras.bin");
    let mut devices = Vec::new();
    for _ in 0..bytes.count()? {
        let id = u32::from_le_bytes(bytes.take()?);
        let place = |name: &str| Place::on_line(0, format!("camera {id}: {name}"));
        let number = i32::from_le_bytes(bytes.take()?);
        let model = model::find(None, number, || place("MODEL"))?;
        let size = [bytes.count()? as f64, bytes.count()? as f64];
        let size = [
            pixels(place("WIDTH"), size[0])?,
            pixels(place("HEIGHT"), size[1])?,
        ];
        let parameters = (0..model.parameters).map(|_| bytes.number());
        let parameters = parameters.collect::<Result<Vec<_>, _>>()?;
        devices.push(Device {
            id,
            size,
            intrinsics: model.intrinsics(&parameters, || place("PARAMS"))?,
            line: 0,
        });
    }
    bytes.end()?;
    match devices.is_empty() {
        false => distinct(devices),
        true => Err(bytes.refuse("there are no cameras")),
    }
}

pub(super) fn shots(bytes: &[u8]) -> Result<Vec<Shot>, CameraFileError> {
    let mut bytes = Bytes::new(bytes, "COLMAP's images.bin");
    let mut shots = Vec::new();
    for _ in 0..bytes.count()? {
        bytes.take::<4>()?;
        let quaternion = bytes.numbers()?;
        let along = bytes.numbers()?;
        let pose = pose(quaternion, along);
        let pose = pose.ok_or_else(|| bytes.refuse("the quaternion before this is no rotation"))?;
        let device = u32::from_le_bytes(bytes.take()?);
        let name = bytes.text()?;
        let points = bytes.count()?;
        bytes.skip(points, 24)?;
        shots.push(Shot {
            device,
            name,
            pose,
            place: 0,
        });
    }
    bytes.end()?;
    Ok(shots)
}
