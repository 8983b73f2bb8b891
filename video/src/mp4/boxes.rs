//! The boxes of an MP4 file. Crate re_mp4 reads what is in them; the tree is walked here, since
//! that crate does not end on boxes of length 0 and trusts the numbers of one box in another.

use std::io::{self, Cursor, Read, Seek, SeekFrom};

use re_mp4::ReadBox;

/// Bytes of a length and a name.
const HEADER: usize = 8;

/// A box in memory.
#[derive(Clone, Copy)]
pub(super) struct Node<'a> {
    pub(super) name: [u8; 4],
    /// The contents, after 8 other bytes.
    bytes: &'a [u8],
}

impl<'a> Node<'a> {
    pub(super) fn contents(&self) -> &'a [u8] {
        &self.bytes[HEADER..]
    }

    /// The boxes in this one, after `skipped` bytes.
    pub(super) fn children(&self, skipped: usize) -> Result<Vec<Self>, String> {
        children(self.bytes, HEADER + skipped)
    }

    /// The first box of this name in this one.
    pub(super) fn child(&self, name: &[u8; 4]) -> Result<Self, String> {
        self.find(name)?
            .ok_or_else(|| format!("the box {} is missing", name.escape_ascii()))
    }

    pub(super) fn find(&self, name: &[u8; 4]) -> Result<Option<Self>, String> {
        let children = self.children(0)?;
        Ok(children.into_iter().find(|child| child.name == *name))
    }

    /// What crate re_mp4 reads in the box.
    pub(super) fn parse<T: for<'c> ReadBox<&'c mut Cursor<&'a [u8]>>>(&self) -> Result<T, String> {
        let mut cursor = Cursor::new(self.bytes);
        cursor.set_position(HEADER as u64);
        T::read_box(&mut cursor, self.bytes.len() as u64)
            .map_err(|error| format!("the box {}: {error}", self.name.escape_ascii()))
    }
}

/// The boxes in `bytes` from `at` on, which is at least 8.
fn children(bytes: &[u8], mut at: usize) -> Result<Vec<Node<'_>>, String> {
    let mut found = Vec::new();
    // Less than a header at the end is a filler.
    while let Some(header) = bytes.get(at..).and_then(<[u8]>::first_chunk::<HEADER>) {
        let (mut length, name) = parts(*header);
        let mut start = at + HEADER;
        if length == 1 {
            let Some(long) = bytes[start..].first_chunk::<8>() else {
                return Err("a box ends within its length".into());
            };
            length = u64::from_be_bytes(*long);
            start += 8;
        }
        // A length of 0 is for the last box of a file, not for one inside another.
        let end = usize::try_from(length).ok().and_then(|n| at.checked_add(n));
        let Some(end) = end.filter(|end| (start..=bytes.len()).contains(end)) else {
            let name = name.escape_ascii();
            return Err(format!(
                "the box {name} does not fit into the one around it"
            ));
        };
        let bytes = &bytes[start - HEADER..end];
        found.push(Node { name, bytes });
        at = end;
    }
    Ok(found)
}

fn parts([a, b, c, d, name @ ..]: [u8; HEADER]) -> (u64, [u8; 4]) {
    (u64::from(u32::from_be_bytes([a, b, c, d])), name)
}

/// The box `moov`, in memory.
pub(super) struct Index(Vec<u8>);

impl Index {
    pub(super) fn root(&self) -> Node<'_> {
        Node {
            name: *b"moov",
            bytes: &self.0,
        }
    }

    /// Finds the index in a file of `length` bytes and reads it; the error within says why the file
    /// has none.
    pub(super) fn read(
        file: &mut (impl Read + Seek),
        length: u64,
    ) -> io::Result<Result<Self, String>> {
        let mut at = 0;
        while at + HEADER as u64 <= length {
            file.seek(SeekFrom::Start(at))?;
            let mut header = [0; HEADER];
            file.read_exact(&mut header)?;
            let (mut size, name) = parts(header);
            let mut start = at + HEADER as u64;
            if size == 1 && start + 8 <= length {
                let mut long = [0; 8];
                file.read_exact(&mut long)?;
                size = u64::from_be_bytes(long);
                start += 8;
            }
            let end = match size {
                0 => length,
                _ => at.saturating_add(size),
            };
            if end < start {
                let name = name.escape_ascii();
                return Ok(Err(format!("the box {name} is shorter than its header")));
            }
            if end > length {
                break;
            }
            if name == *b"moov" {
                let mut bytes = vec![0; HEADER];
                file.take(end - start).read_to_end(&mut bytes)?;
                return Ok(Ok(Self(bytes)));
            }
            at = end;
        }
        Ok(Err(
            "the file ends before its index, the box moov: it is truncated or was not finished"
                .into(),
        ))
    }
}
