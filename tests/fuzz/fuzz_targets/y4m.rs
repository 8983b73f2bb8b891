//! Y4M: the film in memory and the film that streams have the same frames, up to the same place.
#![no_main]

use ga_image::plane::Plane;
use ga_image::y4m::{Number, Reader, Stream};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(header) = Stream::new(data).map(|stream| *stream.header()) else {
        return;
    };
    if header.bit_depth == 10 {
        let frames = stream::<u16>(data);
        assert!(frames.iter().flatten().all(|plane| plane.values().iter().all(|v| *v < 1024)));
        return;
    }
    let streamed = stream::<u8>(data);
    // The film in memory refuses a size that the file cannot hold at once, the stream at the end of
    // the file; it knows nothing of films that were joined.
    let Ok(reader) = Reader::new(data) else {
        assert!(streamed.is_empty());
        return;
    };
    let frames = reader.map_while(Result::ok).zip(&streamed);
    for (frame, planes) in frames {
        assert_eq!(frame.luma.to_plane(), planes[0]);
        assert_eq!(frame.differences[0].to_plane(), planes[1]);
        assert_eq!(frame.differences[1].to_plane(), planes[2]);
    }
});

/// The frames until the end or an error, as long as they are not many.
fn stream<T: Number>(data: &[u8]) -> Vec<[Plane<T>; 3]> {
    let mut stream = Stream::new(data).expect("the header was read before");
    let mut frames = Vec::new();
    loop {
        let mut planes = [(); 3].map(|()| Plane::default());
        let [luma, cb, cr] = &mut planes;
        match stream.read([luma, cb, cr]) {
            Ok(true) if frames.len() < 1000 => frames.push(planes),
            _ => return frames,
        }
    }
}
