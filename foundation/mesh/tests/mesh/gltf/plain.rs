//! glTF files as JSON and bytes, read without the crate.

use std::path::Path;

use base64::Engine;
use serde_json::Value;

/// A file: its JSON, and the bytes of each buffer.
pub(super) struct Plain {
    pub(super) json: Value,
    pub(super) buffers: Vec<Vec<u8>>,
}

impl Plain {
    pub(super) fn read(path: &Path) -> Self {
        let file = std::fs::read(path).unwrap();
        let folder = path.parent().unwrap();
        Self::decode(&file, |name| std::fs::read(folder.join(name)).unwrap())
    }

    pub(super) fn decode(file: &[u8], read: impl Fn(&str) -> Vec<u8>) -> Self {
        let word = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
        let (text, binary) = if file.starts_with(b"glTF") {
            let end = 20 + word(12);
            (&file[20..end], file.get(end + 8..))
        } else {
            (file, None)
        };
        let json: Value = serde_json::from_slice(text).unwrap();
        let buffers = json["buffers"].as_array().cloned().unwrap_or_default();
        let bytes = |buffer: &Value| match buffer["uri"].as_str() {
            None => binary.unwrap().to_vec(),
            Some(uri) => match uri.split_once("base64,") {
                Some((_, data)) => base64::prelude::BASE64_STANDARD.decode(data).unwrap(),
                None => read(uri),
            },
        };
        let buffers = buffers.iter().map(bytes).collect();
        Self { json, buffers }
    }

    pub(super) fn count(&self, list: &str) -> usize {
        self.json[list].as_array().map_or(0, Vec::len)
    }

    /// The bytes of a buffer view.
    pub(super) fn view(&self, view: &Value) -> &[u8] {
        let view = &self.json["bufferViews"][number(view)];
        let start = view.get("byteOffset").map_or(0, number);
        &self.buffers[number(&view["buffer"])][start..start + number(&view["byteLength"])]
    }

    /// The bytes of each item of an accessor, with sparse changes.
    pub(super) fn items(&self, accessor: &Value) -> Vec<Vec<u8>> {
        let size = match number(&accessor["componentType"]) {
            5120 | 5121 => 1,
            5122 | 5123 => 2,
            _ => 4,
        } * match accessor["type"].as_str().unwrap() {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            "MAT4" => 16,
            other => panic!("{other} is in no test"),
        };
        let count = number(&accessor["count"]);
        let run = |bytes: &[u8], stride: usize, count: usize| -> Vec<Vec<u8>> {
            let item = |index: usize| bytes[index * stride..][..size].to_vec();
            (0..count).map(item).collect()
        };
        let offset = |part: &Value| part.get("byteOffset").map_or(0, number);
        let mut items = match accessor.get("bufferView") {
            Some(view) => {
                let stride = &self.json["bufferViews"][number(view)]["byteStride"];
                let stride = stride.as_u64().map_or(size, |stride| stride as usize);
                run(&self.view(view)[offset(accessor)..], stride, count)
            }
            None => vec![vec![0; size]; count],
        };
        if let Some(sparse) = accessor.get("sparse") {
            let count = number(&sparse["count"]);
            let (indices, values) = (&sparse["indices"], &sparse["values"]);
            let values = run(
                &self.view(&values["bufferView"])[offset(values)..],
                size,
                count,
            );
            let bytes = &self.view(&indices["bufferView"])[offset(indices)..];
            for (place, value) in values.into_iter().enumerate() {
                let index = match number(&indices["componentType"]) {
                    5121 => usize::from(bytes[place]),
                    5123 => usize::from(u16::from_le_bytes(
                        bytes[2 * place..][..2].try_into().unwrap(),
                    )),
                    _ => panic!("indices of four bytes are in no test"),
                };
                items[index] = value;
            }
        }
        items
    }

    /// The items of every accessor.
    pub(super) fn all_items(&self) -> Vec<Vec<Vec<u8>>> {
        let accessors = self.json["accessors"].as_array();
        let accessors = accessors.into_iter().flatten();
        accessors.map(|accessor| self.items(accessor)).collect()
    }

    /// The JSON but for where bytes are.
    pub(super) fn meaning(&self) -> Value {
        let mut json = self.json.clone();
        let object = json.as_object_mut().unwrap();
        object.remove("buffers");
        object.remove("bufferViews");
        let list =
            |json: &mut Value, name: &str| json[name].as_array().cloned().unwrap_or_default();
        for name in ["accessors", "images"] {
            let mut items = list(&mut json, name);
            for item in items.iter_mut().filter_map(Value::as_object_mut) {
                for key in ["bufferView", "byteOffset", "uri", "mimeType"] {
                    item.remove(key);
                }
                if let Some(sparse) = item.get_mut("sparse") {
                    for part in ["indices", "values"] {
                        sparse[part].as_object_mut().unwrap().remove("bufferView");
                    }
                }
            }
            json[name] = items.into();
        }
        json
    }
}

pub(super) fn number(value: &Value) -> usize {
    value.as_u64().unwrap() as usize
}
