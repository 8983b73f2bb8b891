//! Material libraries that deviate from their format.

use ga_mesh::obj::mtl;

use crate::materials::load;

/// A fault of a library makes neither the shape nor the other materials unreadable.
#[test]
fn deviations_of_libraries_are_warnings() {
    let ignored = "this is ignored";
    for (lines, opacity, warning) in [
        ("newmtl\nKd 0 1 0", 1.0, "line 1: a newmtl line has a name, but this one has none; the material is left out".to_owned()),
        ("Kd 0 1 0", 1.0, format!("line 1: Kd comes before the first newmtl line; {ignored}")),
        ("# none\nnewmtl a\nNs\nKe 1 2", 1.0, format!("line 3: a Ns line has one number, but this one has 0; {ignored}")),
        ("newmtl a\nKd 1 0 0 1", 1.0, "line 2: a Kd line has 1 or 3 numbers, but this one has 4; the numbers beyond are ignored".to_owned()),
        ("newmtl a\nKs spectral ident.rfl 0", 1.0, format!("line 2: Ks spectral is not supported; write red, green and blue; {ignored}")),
        ("newmtl a\nbump -bm b.png", 1.0, format!("line 2: the option -bm of bump has no value; {ignored}")),
        ("newmtl a\nmap_Kd -clamp b.png", 1.0, format!("line 2: the option -clamp of map_Kd has no value; {ignored}")),
        ("newmtl a\nfoo 1\nbar 2\nfoo 3", 1.0, format!("line 2: foo is no statement of MTL; {ignored} (2 such lines)")),
        ("newmtl a\nd 0.5\nTr 1", 0.5, "line 3: the opacity 1 − Tr is another than that by d; that by d counts".to_owned()),
        ("newmtl a\nTr 1\nd 0.5", 0.5, "line 3: the opacity 1 − Tr is another than that by d; that by d counts".to_owned()),
    ] {
        let library = format!("{lines}\nnewmtl red\nKd 1 0 0\n");
        let (mesh, warnings) = load("mtllib a.mtl\nusemtl red\nf 1 2 3\n", &library);
        assert_eq!(mesh.material(0).unwrap().base_colour, [1.0, 0.0, 0.0, 1.0]);
        let a = mesh.materials().iter().find(|material| material.name == "a");
        assert_eq!(a.map_or(1.0, |a| a.base_colour[3]), opacity, "{lines}");
        let sentences: Vec<String> = warnings.iter().map(ToString::to_string).collect();
        assert_eq!(sentences[0], format!("a.mtl: {warning}"));
        let of_file = warnings[0].of_file("models/b.obj".as_ref());
        assert_eq!(of_file.file.unwrap().to_str(), Some("models/a.mtl"));
        assert_eq!((of_file.message, of_file.line.is_some()), (warning, true));
    }
    // The same opacity by both, and statements that are not used here.
    let library = "newmtl red\nd 0.25\nTr 0.75\nTf 1 1 1\nrefl -type sphere sky.png\nPcr 1\n";
    let (mesh, warnings) = load("mtllib a.mtl\nusemtl red\nf 1 2 3\n", library);
    assert_eq!(
        (mesh.material(0).unwrap().base_colour[3], warnings),
        (0.25, vec![])
    );
    for library in [
        "newmtl a\nKd 1 0 x\n",
        "newmtl a\nd nan\n",
        "newmtl a\nbump -bm x b.png\n",
    ] {
        let error = mtl::decode(library.as_bytes()).unwrap_err().to_string();
        assert!(error.starts_with("line 2: "), "{error}");
    }
    let names = mtl::decode(b"newmtl Gr\xfcn\rKd 0 1 0\r").unwrap();
    assert_eq!(
        (names[0].name.as_str(), names[0].base_colour[0]),
        ("Grün", 0.0)
    );
}
