//! Numbers of few bits, one after the other.

/// Quotients of [`BitWriter::rice`] from here on are written in full.
const ESCAPE: u32 = 20;

/// Writes bits, the least significant one first.
#[derive(Default)]
pub(super) struct BitWriter {
    bytes: Vec<u8>,
    /// How many bits of the last byte are used; 0 when it is full.
    used: u32,
}

impl BitWriter {
    /// The lowest `count` bits of `value`, at most 32.
    pub(super) fn bits(&mut self, value: u32, count: u32) {
        for bit in 0..count {
            if self.used == 0 {
                self.bytes.push(0);
            }
            if let Some(last) = self.bytes.last_mut() {
                *last |= ((value >> bit & 1) as u8) << self.used;
            }
            self.used = (self.used + 1) % 8;
        }
    }

    /// A number by the code of Golomb and Rice: what `parameter` bits do not hold, counted in ones,
    /// then those bits. Numbers of either sign alternate: 0, −1, 1, −2, 2, …
    pub(super) fn rice(&mut self, value: i32, parameter: u32) {
        let code = zigzag(value);
        let quotient = code.checked_shr(parameter).unwrap_or(0);
        if quotient >= ESCAPE {
            self.bits(u32::MAX, ESCAPE);
            self.bits(code, 32);
        } else {
            self.bits((1 << quotient) - 1, quotient + 1);
            self.bits(code, parameter);
        }
    }

    /// The bytes, the last one filled up with zeros.
    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }
}

/// How many bits [`BitWriter::rice`] takes.
pub(super) fn rice_bits(value: i32, parameter: u32) -> u64 {
    let quotient = zigzag(value).checked_shr(parameter).unwrap_or(0);
    u64::from(if quotient >= ESCAPE {
        ESCAPE + 32
    } else {
        quotient + 1 + parameter
    })
}

/// The parameter with which [`BitWriter::rice`] writes numbers in the fewest bits.
pub(super) fn best_parameter(values: impl Iterator<Item = i32> + Clone) -> u32 {
    let cost = |parameter: u32| -> u64 {
        let bits = values.clone().map(|value| rice_bits(value, parameter));
        bits.sum()
    };
    (0..=MOST_PARAMETER)
        .min_by_key(|&parameter| cost(parameter))
        .unwrap_or(0)
}

/// The greatest parameter of [`best_parameter`].
pub(super) const MOST_PARAMETER: u32 = 24;

fn zigzag(value: i32) -> u32 {
    ((value << 1) ^ (value >> 31)) as u32
}

/// Reads what a [`BitWriter`] wrote. Beyond the end, every number is `None`.
pub(super) struct BitReader<'a> {
    bytes: &'a [u8],
    position: usize,
}

impl<'a> BitReader<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, position: 0 }
    }

    pub(super) fn bits(&mut self, count: u32) -> Option<u32> {
        let mut value = 0;
        for bit in 0..count {
            let byte = self.bytes.get(self.position / 8)?;
            value |= u32::from(byte >> (self.position % 8) & 1) << bit;
            self.position += 1;
        }
        Some(value)
    }

    pub(super) fn rice(&mut self, parameter: u32) -> Option<i32> {
        let mut quotient = 0;
        while quotient < ESCAPE && self.bits(1)? == 1 {
            quotient += 1;
        }
        let code = if quotient == ESCAPE {
            self.bits(32)?
        } else {
            (quotient << parameter) | self.bits(parameter)?
        };
        Some((code >> 1) as i32 ^ -((code & 1) as i32))
    }

    /// The bytes that no number has been read from.
    pub(super) fn rest(self) -> &'a [u8] {
        self.bytes.get(self.position.div_ceil(8)..).unwrap_or(&[])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn what_is_written_is_read(
            values in proptest::collection::vec((any::<i32>(), 0u32..=32, 0u32..=24), 0..50),
        ) {
            let mut writer = BitWriter::default();
            for &(value, shift, parameter) in &values {
                let value = value.checked_shr(shift).unwrap_or(0);
                writer.rice(value, parameter);
                writer.bits(value as u32, parameter);
            }
            let bytes = writer.into_bytes();
            let mut reader = BitReader::new(&bytes);
            for &(value, shift, parameter) in &values {
                let value = value.checked_shr(shift).unwrap_or(0);
                prop_assert_eq!(reader.rice(parameter), Some(value));
                let mask = ((1u64 << parameter) - 1) as u32;
                prop_assert_eq!(reader.bits(parameter), Some(value as u32 & mask));
            }
            prop_assert!(reader.rest().is_empty());
        }

        #[test]
        fn the_best_parameter_is_no_worse_than_any(
            values in proptest::collection::vec(-5000i32..5000, 1..40),
            other in 0u32..=24,
        ) {
            let length = |parameter| {
                let mut writer = BitWriter::default();
                for &value in &values {
                    writer.rice(value, parameter);
                }
                writer.into_bytes().len()
            };
            prop_assert!(length(best_parameter(values.iter().copied())) <= length(other));
        }
    }
}
