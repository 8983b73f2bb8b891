//! Numbers in bytes, little-endian.

use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;

use super::super::layout::{from_steps, to_steps};

/// Reads numbers from bytes; beyond the end, every number is `None`.
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
}

impl<'a> Cursor<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes }
    }

    pub(super) fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.bytes.split_at_checked(count)?;
        self.bytes = rest;
        Some(taken)
    }

    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (taken, rest) = self.bytes.split_first_chunk()?;
        self.bytes = rest;
        Some(*taken)
    }

    pub(super) fn u8(&mut self) -> Option<u8> {
        self.array().map(u8::from_le_bytes)
    }

    pub(super) fn u32(&mut self) -> Option<u32> {
        self.array().map(u32::from_le_bytes)
    }

    /// A finite number.
    pub(super) fn f32(&mut self) -> Option<f32> {
        self.array()
            .map(f32::from_le_bytes)
            .filter(|x| x.is_finite())
    }

    /// A finite number.
    pub(super) fn f64(&mut self) -> Option<f64> {
        self.array()
            .map(f64::from_le_bytes)
            .filter(|x| x.is_finite())
    }

    pub(super) fn vector(&mut self) -> Option<Vector<f32>> {
        Some(Vector::new(self.f32()?, self.f32()?, self.f32()?))
    }

    /// A unit rotor.
    pub(super) fn rotor(&mut self) -> Option<Rotor<f32>> {
        let [s, e12, e13, e23] = [self.f32()?, self.f32()?, self.f32()?, self.f32()?];
        let square = s * s + e12 * e12 + e13 * e13 + e23 * e23;
        ((square - 1.0).abs() < 1e-3).then(|| Rotor::new_unchecked(s, e12, e13, e23))
    }

    /// A rotor in steps.
    pub(super) fn short_rotor(&mut self) -> Option<Rotor<f32>> {
        let mut step = || self.array().map(i16::from_le_bytes);
        Some(from_steps([step()?, step()?, step()?]))
    }

    /// A whole number in groups of seven bits, the lowest first.
    pub(super) fn variable(&mut self) -> Option<u32> {
        let mut value = 0u32;
        for group in 0..5 {
            let byte = u32::from(self.u8()?);
            let bits = byte & 0x7f;
            if group == 4 && bits > 0xf {
                return None;
            }
            value |= bits << (7 * group);
            if byte & 0x80 == 0 {
                return Some(value);
            }
        }
        None
    }

    pub(super) fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    pub(super) fn rest(&self) -> &'a [u8] {
        self.bytes
    }
}

pub(super) fn put_variable(bytes: &mut Vec<u8>, mut value: u32) {
    while value > 0x7f {
        bytes.push(value as u8 | 0x80);
        value >>= 7;
    }
    bytes.push(value as u8);
}

pub(super) fn put_vector(bytes: &mut Vec<u8>, vector: Vector<f32>) {
    for x in vector.coordinates() {
        bytes.extend(x.to_le_bytes());
    }
}

pub(super) fn put_rotor(bytes: &mut Vec<u8>, rotor: Rotor<f32>) {
    for x in [rotor.scalar(), rotor.e12(), rotor.e13(), rotor.e23()] {
        bytes.extend(x.to_le_bytes());
    }
}

pub(super) fn put_short_rotor(bytes: &mut Vec<u8>, rotor: Rotor<f32>) {
    for step in to_steps(rotor) {
        bytes.extend(step.to_le_bytes());
    }
}

/// Whether a rotor comes back from its steps as it was.
pub(super) fn is_short(rotor: Rotor<f32>) -> bool {
    from_steps(to_steps(rotor)) == rotor
}
