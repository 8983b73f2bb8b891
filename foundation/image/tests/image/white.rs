//! Pictures whose numbers fill a part of 16 bits.

use ga_image::grey::Luma;
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_image::pnm;

/// Numbers of any depth become levels within half a step of what they are of their white.
#[test]
fn numbers_of_every_depth_reach_white() {
    for bits in [8, 10, 12, 14, 16] {
        let white = (1u32 << bits) - 1;
        let stored = Plane::from_fn(64, 2, |column, row| {
            (column as u32 * white / 63 / (row as u32 + 1)) as u16
        });
        let [spread] = Picture::spread([stored.clone().into()]);
        let Picture::Grey16(spread) = spread else {
            panic!("not grey");
        };
        for (got, number) in spread.values().iter().zip(stored.values()) {
            let expected = f64::from(*number) * 65535.0 / f64::from(white);
            assert!((f64::from(*got) - expected).abs() <= 0.5, "{bits} bits");
        }
        // A portable grey map says what white is.
        let text = format!(
            "P2 64 1 {white} {}",
            (0..64)
                .map(|k| format!("{} ", k * white / 63))
                .collect::<String>()
        );
        let picture = pnm::decode(text.as_bytes()).unwrap();
        let grey = picture.to_grey::<f32>(Luma::Bt601);
        assert!((grey.row(0)[63] - 1.0).abs() < 1e-6);
        assert_eq!(Picture::spread([picture.clone()]), [picture]);
    }
}

#[test]
fn the_brightest_of_a_set_decides_for_all() {
    let dark = Plane::filled(2, 2, 200u16);
    let bright = Plane::filled(2, 2, [4000u16, 100, 7]);
    let bytes = Plane::filled(2, 2, 200u8);
    let pictures = [dark.into(), bright.into(), bytes.clone().into()];
    let [dark, bright, unchanged] = Picture::spread(pictures);
    // 200 · 65535 / 4095 is 3200.7, and so on.
    assert_eq!(dark, Plane::filled(2, 2, 3201u16).into());
    assert_eq!(bright, Plane::filled(2, 2, [64015u16, 1600, 112]).into());
    assert_eq!(unchanged, bytes.into());
}

#[test]
fn alpha_does_not_count() {
    let picture = Plane::filled(1, 1, [1023u16, 512, 0, 65535]);
    let [spread] = Picture::spread([picture.into()]);
    assert_eq!(
        spread,
        Plane::filled(1, 1, [65535u16, 32800, 0, 65535]).into()
    );
    let picture = Plane::filled(1, 1, [1023u16, 40_000]);
    let [spread] = Picture::spread([picture.into()]);
    assert_eq!(spread, Plane::filled(1, 1, [65535u16, 40_000]).into());
    let black = Plane::filled(3, 1, 0u16);
    assert_eq!(Picture::spread([black.clone().into()]), [black.into()]);
}
