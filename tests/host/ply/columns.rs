//! Columns of programs that grew from 3DGS: those that change what splats are, and those that are
//! passed over.

use effigy_core::{
    avatar::ShCoefficients,
    io::{
        assumption::Assumption,
        ply,
        splats::{Found, Up},
    },
};

/// A column: its type in the header, its name and its numbers.
#[derive(Clone)]
struct Column {
    kind: &'static str,
    name: String,
    values: Vec<f64>,
}

const COUNT: usize = 5;

fn column(kind: &'static str, name: &str, value: impl Fn(usize) -> f64) -> Column {
    Column {
        kind,
        name: name.into(),
        values: (0..COUNT).map(value).collect(),
    }
}

/// What every splat has, without scales and colours.
fn base() -> Vec<Column> {
    let mut columns: Vec<Column> = ["x", "y", "z"]
        .map(|name| column("float", name, |k| 0.1 * k as f64))
        .into();
    columns.extend(["nx", "ny", "nz"].map(|name| column("float", name, |_| 0.0)));
    columns.extend((0..4).map(|k| {
        column("float", &format!("rot_{k}"), move |row| {
            if k == 0 { 1.0 } else { 0.1 * row as f64 }
        })
    }));
    columns.push(column("float", "opacity", |k| k as f64 - 1.0));
    columns
}

fn scales(axes: usize) -> Vec<Column> {
    let scale = |k: usize| {
        column("float", &format!("scale_{k}"), move |row| {
            -3.0 - (k + row) as f64
        })
    };
    (0..axes).map(scale).collect()
}

fn colors() -> Vec<Column> {
    let color = |k: usize| {
        column("float", &format!("f_dc_{k}"), move |row| {
            0.2 * (row + k) as f64
        })
    };
    (0..3).map(color).collect()
}

fn header(format: &str, columns: &[Column]) -> String {
    let properties = columns
        .iter()
        .map(|c| format!("property {} {}\n", c.kind, c.name));
    let properties: String = properties.collect();
    format!("ply\nformat {format} 1.0\nelement vertex {COUNT}\n{properties}end_header\n")
}

fn binary(columns: &[Column]) -> Vec<u8> {
    let mut bytes = header("binary_little_endian", columns).into_bytes();
    for row in 0..COUNT {
        for column in columns {
            let value = column.values[row];
            match column.kind {
                "uchar" => bytes.push(value as u8),
                "ushort" => bytes.extend((value as u16).to_le_bytes()),
                "short" => bytes.extend((value as i16).to_le_bytes()),
                "int" => bytes.extend((value as i32).to_le_bytes()),
                "double" => bytes.extend(value.to_le_bytes()),
                _ => bytes.extend((value as f32).to_le_bytes()),
            }
        }
    }
    bytes
}

fn text(columns: &[Column]) -> Vec<u8> {
    let mut text = header("ascii", columns);
    for row in 0..COUNT {
        let words: Vec<String> = columns.iter().map(|c| c.values[row].to_string()).collect();
        text += &format!("{}\n", words.join(" "));
    }
    text.into_bytes()
}

fn found(bytes: &[u8]) -> Found {
    ply::read(bytes).and_then(Found::sound).unwrap()
}

/// What is said of columns. No file here says which axis points up.
fn said(found: &Found) -> String {
    let (up, own): (Vec<&Assumption>, Vec<&Assumption>) = found
        .assumptions
        .iter()
        .partition(|own| own.what == Up::QUESTION);
    assert_eq!(up, [&Up::assumed()]);
    let lines: Vec<String> = own.iter().map(ToString::to_string).collect();
    lines.join("\n")
}

fn fewer_scales_are_discs_and_balls() {
    let of = |axes| found(&binary(&[base(), scales(axes), colors()].concat()));
    assert_eq!(said(&of(3)), "");
    let discs = of(2);
    for (k, scale) in discs.splats.log_scale.iter().enumerate() {
        let thin = (1e-6f64).ln() as f32;
        assert_eq!(*scale, [-3.0 - k as f32, -4.0 - k as f32, thin]);
    }
    assert!(
        said(&discs).starts_with("shape: discs, 1e-6 m thick"),
        "{}",
        said(&discs)
    );
    let balls = of(1);
    assert_eq!(balls.splats.log_scale[2], [-5.0; 3]);
    assert!(said(&balls).starts_with("shape: balls"), "{}", said(&balls));
    let none = ply::read(&binary(&[base(), colors()].concat()))
        .unwrap_err()
        .to_string();
    assert!(
        none.starts_with("found no `scale_0` among the properties x, y"),
        "{none}"
    );
}

fn colours_without_harmonics_are_read_by_their_type() {
    let expected = |part: f64| ((part - 0.5) / ShCoefficients::CONSTANT) as f32;
    for (kind, names, full) in [
        ("uchar", ["red", "green", "blue"], 255.0),
        ("ushort", ["red", "green", "blue"], 65_535.0),
        ("float", ["red", "green", "blue"], 255.0),
        ("float", ["r", "g", "b"], 1.0),
        ("double", ["red", "green", "blue"], 1.0),
        ("ushort", ["red", "green", "blue"], 255.0),
        ("short", ["red", "green", "blue"], 32_767.0),
        ("int", ["red", "green", "blue"], 255.0),
    ] {
        let color = |k: usize| {
            let part = move |row: usize| (row + k) as f64 / 10.0;
            let stored = move |row: usize| match full {
                1.0 => part(row),
                full => (full * part(row)).round(),
            };
            column(kind, names[k], stored)
        };
        let columns = [base(), scales(3), vec![color(0), color(1), color(2)]].concat();
        for bytes in [binary(&columns), text(&columns)] {
            let read = found(&bytes);
            for (row, rgb) in read.splats.color.iter().enumerate() {
                for (k, value) in rgb.iter().enumerate() {
                    let off = (value - expected((row + k) as f64 / 10.0)).abs();
                    assert!(
                        off < 0.51 / full as f32 / 0.28 + 1e-5,
                        "{kind} {full}: {off}"
                    );
                }
            }
            assert!(
                said(&read).contains(&format!("from 0 to {full}")),
                "{}",
                said(&read)
            );
        }
    }
    // Beside coefficients they are another program's.
    let red = column("uchar", "red", |_| 255.0);
    let both = found(&binary(&[base(), scales(3), colors(), vec![red]].concat()));
    assert_eq!(both.splats.color[1], [0.2, 0.4, 0.6]);
    assert_eq!(
        said(&both),
        "columns: red left out (they are none of 3DGS's)"
    );
}

/// Variances add up, and each splat keeps its mass: opacities fall as volumes grow.
fn a_filter_in_three_dimensions_is_fused() {
    let filter = column("float", "filter_3D", |row| {
        [0.02, 0.0, 0.5, 1e-4, f64::NAN][row]
    });
    let read = ply::read(&binary(
        &[base(), scales(3), colors(), vec![filter.clone()]].concat(),
    ));
    let read = read.unwrap().splats;
    for row in 0..4 {
        let f = filter.values[row] as f32 as f64;
        let deviation = [0, 1, 2].map(|k| (-3.0 - (k + row) as f64).exp());
        let fused = deviation.map(|s| (s * s + f * f).sqrt());
        let volume = |d: [f64; 3]| d.iter().product::<f64>();
        let before = 1.0 / (1.0 + (1.0 - row as f64).exp());
        let opacity = before * volume(deviation) / volume(fused);
        for (read, fused) in read.log_scale[row].iter().zip(fused) {
            assert!((f64::from(*read) - fused.ln()).abs() < 1e-6, "row {row}");
        }
        let read = 1.0 / (1.0 + (-f64::from(read.opacity[row])).exp());
        assert!(
            (read / opacity - 1.0).abs() < 1e-4,
            "row {row}: {read} {opacity}"
        );
    }
    // A ball stays one.
    let balls = ply::read(&binary(
        &[base(), scales(1), colors(), vec![filter.clone()]].concat(),
    ));
    let balls = balls.unwrap().splats;
    for [a, b, c] in &balls.log_scale[..4] {
        assert!(a == b && b == c, "{a} {b} {c}");
    }
    let sound = found(&binary(
        &[base(), scales(3), colors(), vec![filter]].concat(),
    ));
    assert_eq!(sound.splats.len(), 4);
    assert!(said(&sound).starts_with("column filter_3D: in scales and opacities"));
}

fn columns_that_are_passed_over_are_named_once() {
    let mut others: Vec<Column> = (0..9)
        .map(|k| column("float", &format!("motion_{k}"), |_| 1.0))
        .collect();
    others.push(column("int", "binding_0", |_| 0.0));
    others.push(column("double", "t", |_| 0.0));
    let read = found(&binary(&[base(), scales(3), others, colors()].concat()));
    let expected = "columns: motion_0 to motion_8, binding_0, t left out (they are none of 3DGS's)";
    assert_eq!(said(&read), expected);
}

fn map_coordinates_come_near_with_all_their_digits() {
    let middle = [512_345.0, 5_401_234.0, 312.0];
    for kind in ["double", "float"] {
        let mut columns = [base(), scales(3), colors()].concat();
        for (axis, column) in columns.iter_mut().take(3).enumerate() {
            column.kind = kind;
            for (row, value) in column.values.iter_mut().enumerate() {
                *value = middle[axis] + 0.001 * (row as f64 - 2.0);
            }
        }
        let mut files = vec![text(&columns)];
        if kind == "double" {
            files.push(binary(&columns));
        }
        for bytes in files {
            let read = found(&bytes);
            for (row, position) in read.splats.position.iter().enumerate() {
                let off = position.map(|v| (f64::from(v) - 0.001 * (row as f64 - 2.0)).abs());
                assert!(off.iter().all(|off| *off < 1e-6), "{position:?}");
            }
            let line = said(&read);
            assert!(
                line.starts_with("place: 512345, 5401234, 312 is the new origin"),
                "{line}"
            );
        }
    }
}

fn comments_may_be_in_any_encoding() {
    let columns = [base(), scales(3), colors()].concat();
    let bytes = binary(&columns);
    let insert = |line: &[u8]| [&bytes[..4], line, &bytes[4..]].concat();
    let plain = found(&bytes).splats;
    for line in [
        &b"comment K\xf6ln\n"[..],
        b"obj_info gr\xfcn \xff\xfe\r\n",
        "comment Köln\n".as_bytes(),
    ] {
        assert_eq!(found(&insert(line)).splats, plain);
    }
    let refused = ply::read(&insert(b"element K\xf6ln 0\n")).unwrap_err();
    assert!(
        refused
            .to_string()
            .contains("expected text outside comments"),
        "{refused}"
    );
}

fn numbers_that_c_libraries_write_for_nan_are_bad_rows() {
    let columns = [base(), scales(3), colors()].concat();
    for word in ["-nan(ind)", "nan", "1.#QNAN", "-1.#IND", "1.#INF", "-inf"] {
        let bytes = String::from_utf8(text(&columns)).unwrap();
        let bytes = bytes.replace("0.4 0.4 0.4 0 0 0", &format!("0.4 {word} 0.4 0 0 0"));
        let read = found(bytes.as_bytes());
        assert_eq!(read.splats.len(), COUNT - 1, "{word}");
        assert!(
            said(&read).contains("1 of 5 left out"),
            "{word}: {}",
            said(&read)
        );
    }
}

tests! {
    fewer_scales_are_discs_and_balls,
    colours_without_harmonics_are_read_by_their_type,
    a_filter_in_three_dimensions_is_fused,
    columns_that_are_passed_over_are_named_once,
    map_coordinates_come_near_with_all_their_digits,
    comments_may_be_in_any_encoding,
    numbers_that_c_libraries_write_for_nan_are_bad_rows,
}
