//! bytemuck: elements are their stored coefficients in memory, in the order of the declaration.

use crate::every_type::every_type;

use bytemuck_1::{Pod, Zeroable};
use ga_runtime::Element;
use ga_runtime::{cga2, cga3, pga2, pga3, sta, vga2, vga3};

/// In memory, an element whose stored coefficients are 1, 2, 3, … consists of those numbers.
fn is_its_coefficients<T, U>(scalar: fn(u8) -> T::Scalar)
where
    T: Element<Scalar = U> + Pod + PartialEq + core::fmt::Debug,
    U: Pod + PartialEq + core::fmt::Debug + core::ops::Neg<Output = U>,
{
    let mut count = 0;
    let value = T::from_numbers(&mut |_| {
        count += 1;
        scalar(count)
    });
    // A blade such as e31 is stored with the other sign.
    let numbers = bytemuck_1::cast_slice::<T, U>(&[value]).to_vec();
    for (place, &number) in (1..=count).zip(&numbers) {
        assert!(
            number == scalar(place) || number == -scalar(place),
            "{value:?}"
        );
    }
    assert_eq!(numbers.len(), usize::from(count));
    assert_eq!(bytemuck_1::cast_slice::<U, T>(&numbers), [value]);
    assert_eq!(
        bytemuck_1::bytes_of(&value).len(),
        usize::from(count) * size_of::<U>()
    );
    let zeros = vec![scalar(0); usize::from(count)];
    assert_eq!(bytemuck_1::cast_slice::<T, U>(&[T::zeroed()]), zeros);
}

macro_rules! check {
    ($($module:ident { $($name:ident),* }),*) => { $( $(
        is_its_coefficients::<$module::$name<f32>, f32>(f32::from);
        is_its_coefficients::<$module::$name<f64>, f64>(f64::from);
    )* )* };
}

#[test]
fn types_are_their_coefficients() {
    every_type!(check);
}

#[test]
fn slices_are_cast_in_place() {
    let mut points = [cga3::Point::new(1.0_f32, 2.0, 3.0); 4];
    for (k, x) in bytemuck_1::cast_slice_mut::<_, f32>(&mut points)
        .iter_mut()
        .enumerate()
    {
        *x = k as f32;
    }
    assert_eq!(points[2], cga3::Point::new(6.0, 7.0, 8.0));
    let motor = cga3::Motor::new_unchecked(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0);
    assert_eq!(
        bytemuck_1::cast::<_, [f64; 8]>(motor),
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]
    );
    assert_eq!(
        bytemuck_1::cast::<_, [f64; 3]>(vga3::Bivector::new(1.0, 2.0, 3.0)),
        [1.0, 2.0, 3.0]
    );
    let bytes: &[u8] = bytemuck_1::cast_slice(&points);
    assert_eq!(bytes.len(), 48);
    // Part of an element is not an element.
    assert!(bytemuck_1::try_cast_slice::<u8, cga3::Point<f32>>(&bytes[..13]).is_err());
    // Any bytes are an element, zero included; facts are not checked.
    assert_eq!(cga3::Rotor::<f64>::zeroed().scalar(), 0.0);
}

/// Every declared type is in the list of types that are plain memory, with the number of its
/// coefficients, and in the list of these tests. Constants store nothing and are in neither.
#[test]
fn no_declared_type_is_left_out() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let read = |path: &str| std::fs::read_to_string(format!("{root}/{path}")).expect(path);
    let lists = [
        read("ga-runtime/src/interop/bytemuck.rs"),
        read("tests/tests/interop/every_type.rs"),
    ];
    let mut count = 0;
    for entry in std::fs::read_dir(format!("{root}/ga-runtime/src/algebras")).unwrap() {
        let text = std::fs::read_to_string(entry.unwrap().path()).unwrap();
        let Some((_, declaration)) = text.split_once("    pub mod ") else {
            continue;
        };
        let (module, declaration) = declaration.split_once(" {").unwrap();
        let (types, _) = declaration.split_once("products {").unwrap();
        let [memory, tests] = lists.each_ref().map(|list| listed(list, module));
        for kind in types.split("        struct ").skip(1) {
            let (name, rest) = kind.split_once(" {").unwrap();
            let (blades, _) = rest.split_once('}').unwrap();
            // The parameters come before a semicolon; points and directions have three numbers.
            let (blades, _) = blades.split_once(';').unwrap_or((blades, ""));
            let blades = blades
                .split(',')
                .map(str::trim)
                .filter(|blade| !blade.is_empty());
            let stored = blades.filter(|blade| !blade.contains('='));
            let stored: usize = stored
                .map(|blade| if blade.contains(": ") { 3 } else { 1 })
                .sum();
            if stored > 0 {
                let entry = format!("{name} {stored}");
                assert!(memory.contains(&entry.as_str()), "{module}: {entry}");
                assert!(tests.contains(&name), "{module}: {name}");
                count += 1;
            }
        }
    }
    assert!(count > 60, "the declarations were found");
}

/// The entries of a list, in the braces after the name of a module.
fn listed<'a>(list: &'a str, module: &str) -> Vec<&'a str> {
    let (_, rest) = list
        .split_once(&format!(" {module} {{"))
        .unwrap_or_else(|| panic!("no types of {module}"));
    let (names, _) = rest.split_once('}').expect("a closing brace");
    names.split(',').map(str::trim).collect()
}
