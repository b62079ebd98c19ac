use super::head::GRAVITY;
use super::*;
use std::f64::consts::FRAC_PI_2;

const XYZ: [Column; 3] = [
    Column::needed(&["x", "easting"], Dim::LENGTH, "m"),
    Column::needed(&["y", "northing"], Dim::LENGTH, "m"),
    Column::needed(&["z", "elevation"], Dim::LENGTH, "m"),
];

fn places(text: impl AsRef<[u8]>) -> Table<3> {
    parse_table(text.as_ref(), &XYZ).unwrap()
}

fn record(head: &str, time: &str, column: &str) -> Result<[Vec<f64>; 2], String> {
    let text = format!("{head}\n2,4\n3,5\n");
    let (time, column) = ([time], [column]);
    let columns =
        [Column::chosen(&time, Dim::TIME, "s"), Column::chosen(&column, Dim::ACCELERATION, "m/s2")];
    let read = parse_table(text.as_bytes(), &columns);
    let read = read.map_err(|e| format!("{e} | {}", e.help.clone().unwrap_or_default()));
    Ok(read?.columns.map(|found| found.unwrap().values))
}

fn error(text: &str) -> String {
    let error = parse_table(text.as_bytes(), &XYZ).unwrap_err();
    format!("{error} | {}", error.help.clone().unwrap_or_default())
}

#[test]
fn one_table_is_read_however_it_is_written() {
    let same = [
        "x_m,y_m,z_m\n1.5,2,3\n-4,5e1,6\n",
        "# recorded somewhere\n\nz_m, name ,x_m,y_m\n3,a,1.5,2\n6,b,-4,5e1\n",
        "\u{feff}X [m];Y [m];Z [m]\r\n1,5;2;3\r\n-4;5e1;6\r\n",
        "x (mm)\ty (cm)\tz (m)\n1500\t200\t3\n-4000\t5000\t6\n",
        "sep=;\nEasting;Northing;Elevation\n1,50;2,0;3\n-4;50;6\n",
        "\"Easting (m)\",\"Northing (m)\",\"Elevation (m)\"\n\"1.5\",\"2\",\"3\"\n-4,50,6\n",
        "# x,y,z\n1.5,2,3\n-4,50,6\n",
        "x,y,z\n[mm],[mm],[m]\n1500,2000,3\n-4000,50000,6\n",
        "X_MM,Y M,Z metres\n1500,2,3\n-4000,50,6\n",
        "x,y,z,,\n1.5,2,3,,\n,,,,\n-4,50,6,,\n",
        "x;y;z;\n1.5;2;3;\n-4;50;6;\n",
        "x,y,z,note\n1.5,2,3,\"a, b\"\n-4,50,6,\n",
    ];
    for text in same {
        let read = places(text);
        let values: Vec<&[f64]> = (0..3).map(|k| read.values(k)).collect();
        assert_eq!(values, [[1.5, -4.0], [2.0, 50.0], [3.0, 6.0]], "{text}");
    }
    let wide: Vec<u8> =
        "\u{feff}x;y;z\n1,5;2;3\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(places(wide).values(0), [1.5]);
    // Latin-1, as older programs of Europe write it.
    assert_eq!(places(b"x;y;z;Gr\xf6\xdfe\n1,5;2;3;4\n").values(0), [1.5]);
}

#[test]
fn what_was_taken_is_noted() {
    let read = places("x;y [m];z\n1,5;2;3\n;;\n");
    let says = "read 1 of 2 rows; left out 1 because they are empty; x, z without a unit, read in m; decimal commas";
    assert_eq!(read.note(), says);
    assert_eq!(read.lines, [2]);
    assert_eq!(places("x_m,y_m,z_m\n1,2,3\n").note(), "read 1 of 1 rows");
}

#[test]
fn columns_of_a_record_are_read_in_their_units() {
    let g = GRAVITY;
    for (head, time, column, values) in [
        ("t_ms,a_g", "t_ms", "a_g", [[0.002, 0.003], [4.0 * g, 5.0 * g]]),
        ("t_ms,a_g", "t", "a", [[0.002, 0.003], [4.0 * g, 5.0 * g]]),
        ("t_s,a_cm_s2", "t_s", "a_cm_s2", [[2.0, 3.0], [4.0 * 1e-2, 5.0 * 1e-2]]),
        ("Time (sec),Accel (cm/s/s)", "Time", "accel", [[2.0, 3.0], [4.0 * 1e-2, 5.0 * 1e-2]]),
        ("time [ms],acc [m/s²]", "time [ms]", "acc [m/s²]", [[0.002, 0.003], [4.0, 5.0]]),
        // Without a unit, or with something behind the underscore that is none.
        ("t,acc_x", "t", "acc_x", [[2.0, 3.0], [4.0, 5.0]]),
        // Just these letters win.
        ("t,a,a_g", "t", "a", [[2.0, 3.0], [4.0, 5.0]]),
    ] {
        let rows = if head.matches(',').count() == 2 { ",9" } else { "" };
        let text = format!("{head}\n2,4{rows}\n3,5{rows}\n");
        let (time, column) = ([time], [column]);
        let columns = [
            Column::chosen(&time, Dim::TIME, "s"),
            Column::chosen(&column, Dim::ACCELERATION, "m/s2"),
        ];
        let read = parse_table(text.as_bytes(), &columns).unwrap();
        for (k, values) in values.iter().enumerate() {
            for (read, value) in read.values(k).iter().zip(values) {
                assert!((read / value - 1.0).abs() < 1e-14, "{text}: {read} for {value}");
            }
        }
    }
    for (head, column, says) in [
        ("t_s,v_mm_s", "v_mm_s", "the column `v_mm_s` is a velocity | expected: an acceleration"),
        ("t_s,a [kN]", "a", "the column `a [kN]` is a force"),
        ("t_s,a [furlong]", "a [furlong]", "unknown unit `furlong`"),
        ("t_s,a_x", "b", "there is no column `b` | the columns are t_s, a_x; name one `b_m_s2`"),
    ] {
        let wrong = record(head, "t_s", column).unwrap_err();
        assert!(wrong.contains(says), "{wrong}");
    }
}

#[test]
fn an_angle_of_the_user_names_its_unit() {
    let read = |head: &str| {
        let text = format!("t_s,{head}\n1,90\n");
        let columns = [Column::chosen(&["theta"], Dim::ANGLE, "rad")];
        parse_table(text.as_bytes(), &columns).map(|read| read.values(0)[0])
    };
    assert_eq!(read("theta_deg").unwrap(), FRAC_PI_2);
    assert_eq!(read("theta_rad").unwrap(), 90.0);
    let refused = read("theta").unwrap_err();
    assert!(refused.message.contains("has no unit"), "{refused}");
    assert!(refused.help.unwrap().contains("`theta [deg]` or `theta [rad]`"));
}

#[test]
fn says_what_is_wrong() {
    for (text, says) in [
        ("", "empty"),
        ("# only a comment\n", "empty"),
        ("x_m,b,z\n1,2,3\n", "no column `y` | the columns are x_m, b, z; name one `y_m`"),
        ("x|y|z\n1|2|3\n", "separate columns by commas, semicolons or tabs"),
        ("0,1,2\n1,2,3\n", "must name the columns"),
        ("0,1;1,5;2\n1;2;3\n", "must name the columns"),
        ("x,y,z,x\n1,2,3,4\n", "the column `x` is given twice"),
        ("x,easting,y,z\n1,2,3,4\n", "the columns `x` and `easting` both give `x`"),
        ("x,y,z\n", "no rows"),
        ("x,y,z\n1,a,3\n", "line 2, column `y`: \"a\" is not a number"),
        ("x,y,z\n1,2,3\n1,nan,3\n", "line 3, column `y`: \"nan\" is not a finite number"),
        ("x,y,z\n1,,3\n", "line 2, column `y`: the cell is empty"),
        ("x,y,z\n1\n", "line 2 has 1 cells, but the header has 3"),
        ("x,y,z\n1,5,2,5,3,5\n", "decimal commas separate cells by semicolons"),
        (
            "x;y;z\n1,5;2.5;3\n",
            "line 2, column `y`: line 2 has a decimal comma, and line 2 a decimal point",
        ),
        ("x;y;z\n1.234,5;2;3\n", "without thousands separators"),
        ("x;y;z\n1,234,567;2;3\n", "without thousands separators"),
        ("x,y,z\n\"1,234\",2,3\n", "without thousands separators"),
        ("x,y,z\n\"1,2\n", "line 2"),
        ("x_kg,y,z\n1,2,3\n", "the column `x_kg` is a mass | expected: a length"),
        ("x,y,z\nm,s,m\n1,2,3\n", "line 2, column `y`: the unit `s` is a time"),
        ("x,y,z\n1,2,\u{0}3\n", "not a text file"),
    ] {
        let wrong = error(text);
        assert!(wrong.contains(says), "{text:?}: {wrong}");
    }
}

#[test]
fn angles_of_planes_have_several_names_and_are_in_degrees() {
    let columns = [
        Column::optional(&["dip"], Dim::ANGLE, "deg"),
        Column::optional(&["dip_direction", "dip_dir", "dip_azimuth"], Dim::ANGLE, "deg"),
    ];
    for text in [
        "dip_direction_deg,dip_deg\n90,90\n",
        "DipDirection[deg],Dip [deg]\n90,90\n",
        "Dip Azimuth (deg), Dip (deg)\n90,90\n",
        "Dip Dir.;DIP\n90;90\n",
        "dip dir (°);dip (°)\n90;90\n",
        "dip_dir_gon,dip_deg\n100,90\n",
    ] {
        let read = parse_table(text.as_bytes(), &columns).unwrap();
        let values = (read.values(0)[0], read.values(1)[0]);
        assert!((values.0 - FRAC_PI_2).abs() < 1e-15, "{text}: {values:?}");
        assert!((values.1 - FRAC_PI_2).abs() < 1e-15, "{text}: {values:?}");
    }
    // A column beside them that happens to begin like one of them.
    let read = parse_table(b"dip,dip_dir,dip_quality\n90,90,3\n", &columns).unwrap();
    assert_eq!(read.values(0), [FRAC_PI_2]);
    assert!(parse_table(b"a\n1\n", &columns).unwrap().columns.iter().all(Option::is_none));
}

#[test]
fn a_unit_of_the_scene_is_stronger_than_that_of_the_head() {
    let mut column = Column::chosen(&["a"], Dim::ACCELERATION, "m/s2");
    column.given = Some(2.0);
    let read = parse_table(b"t,a [kN]\n1,3\n", &[column]).unwrap();
    assert_eq!((read.values(0), read.note()), (&[6.0][..], "read 1 of 1 rows".to_owned()));
}

#[test]
fn names_a_missing_file() {
    let error = csv_table(Path::new("/nowhere/x.csv"), &XYZ).unwrap_err();
    assert!(error.message.contains("/nowhere/x.csv"));
    assert!(csv_table(&std::env::temp_dir(), &XYZ).is_err());
}
