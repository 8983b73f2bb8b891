//! Entropies and mutual information.

use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::{Plane, PlaneError};
use ga_image::quality::{MutualInformation, mutual_information};
use nullcone_shared_data::shared;
use proptest::prelude::*;
use serde_json::Value;

use super::{close, json, number};

fn assert_row(information: &mut MutualInformation, a: &Plane<u8>, b: &Plane<u8>, row: &Value) {
    let got = information.compare(a, b).unwrap();
    close(got.first_bits, number(row, "ha_bits"), 1e-9);
    close(got.second_bits, number(row, "hb_bits"), 1e-9);
    close(got.joint_bits, number(row, "hab_bits"), 1e-9);
    close(got.mutual_bits(), number(row, "mi_bits"), 1e-9);
    close(
        mutual_information(a, b).unwrap(),
        number(row, "mi_bits"),
        1e-9,
    );
}

#[test]
fn the_oracles_pictures_have_its_information() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    let truth = json(&folder.join("truth.json"));
    let read = |name: &str| file::read(folder.join(name)).unwrap();
    let grey = |name: &str| read(name).to_grey::<u8>(Luma::Bt601);
    let mut information = MutualInformation::new();
    let reference = grey(truth["base"]["gray"].as_str().unwrap());
    let rows = truth["quality"].as_array().unwrap();
    assert_eq!(rows.len(), 10);
    for row in rows {
        let picture = grey(row["file"].as_str().unwrap());
        assert_row(&mut information, &reference, &picture, row);
    }

    let base = read(truth["base"]["file"].as_str().unwrap()).to_rgb::<u8>();
    let red = base.channel(0).unwrap();
    let rows = truth["mutual_information_R"]["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 6);
    for row in rows {
        let translation = row["s"].as_u64().unwrap() as usize;
        let moved = Plane::from_fn(red.width(), red.height(), |column, row| {
            red.row(row)[column.saturating_sub(translation)]
        });
        assert_row(&mut information, &red, &moved, row);
    }
}

/// More pixels with one pair of levels than the table of logarithms has entries.
#[test]
fn levels_of_known_shares_have_their_entropy() {
    let a = Plane::from_fn(400, 300, |column, _| if column < 100 { 7u8 } else { 200 });
    let b = Plane::from_fn(400, 300, |_, row| if row < 150 { 255u8 } else { 0 });
    let got = MutualInformation::new().compare(&a, &b).unwrap();
    let quarter = 0.25 * 4f64.log2() + 0.75 * (4.0f64 / 3.0).log2();
    close(got.first_bits, quarter, 1e-12);
    close(got.second_bits, 1.0, 1e-12);
    close(got.joint_bits, quarter + 1.0, 1e-12);
    close(got.mutual_bits(), 0.0, 1e-12);
}

#[test]
fn pictures_without_information_have_none() {
    let flat = Plane::filled(9, 7, 3u8);
    let ramp = Plane::from_fn(9, 7, |column, row| (9 * row + column) as u8);
    let got = MutualInformation::new().compare(&flat, &ramp).unwrap();
    assert_eq!([got.first_bits, got.mutual_bits()], [0.0, 0.0]);
    close(got.second_bits, 63f64.log2(), 1e-12);
}

#[test]
fn pictures_of_other_sizes_are_an_error() {
    let [wide, high] = [(3, 2), (2, 3)].map(|(w, h)| Plane::filled(w, h, 0u8));
    let differs = PlaneError::Differs {
        first: [3, 2],
        second: [2, 3],
    };
    assert_eq!(mutual_information(&wide, &high), Err(differs));
    let empty = Plane::<u8>::default();
    let too_small = PlaneError::TooSmall {
        width: 0,
        height: 0,
        least: 1,
    };
    assert_eq!(mutual_information(&empty, &empty), Err(too_small));
}

/// Two planes of one size, whose levels depend on each other in part.
fn pair() -> impl Strategy<Value = [Plane<u8>; 2]> {
    (1usize..40, 1usize..12, 1u8..=255).prop_flat_map(|(width, height, levels)| {
        let values = || proptest::collection::vec(0..levels, width * height);
        (values(), values(), any::<u8>()).prop_map(move |(a, mut b, share)| {
            for (index, (b, a)) in b.iter_mut().zip(&a).enumerate() {
                if (index * 37) as u8 <= share {
                    *b = a.wrapping_mul(3);
                }
            }
            [a, b].map(|values| Plane::from_values(width, height, values).unwrap())
        })
    })
}

proptest! {
    #[test]
    fn information_has_the_properties_of_shannons(planes in pair()) {
        let [a, b] = &planes;
        let mut information = MutualInformation::new();
        let [there, back, own] =
            [(a, b), (b, a), (a, a)].map(|(a, b)| information.compare(a, b).unwrap());
        close(there.mutual_bits(), back.mutual_bits(), 1e-12);
        prop_assert_eq!(there.first_bits, back.second_bits);
        close(own.mutual_bits(), own.first_bits, 1e-12);
        prop_assert!(there.mutual_bits() <= there.first_bits.min(there.second_bits) + 1e-12);
        prop_assert!(there.joint_bits >= there.first_bits.max(there.second_bits) - 1e-12);
        // Other names for the levels change nothing.
        let named = information.compare(a, &b.map(|v| 255 - v)).unwrap();
        close(named.mutual_bits(), there.mutual_bits(), 1e-12);
    }
}
