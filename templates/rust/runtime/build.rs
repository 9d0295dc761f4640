//! Lists the charts in this folder, so that a new one needs no line elsewhere.
use std::{env, fs, path::Path};

/// Files of the crate that are no charts.
const OWN: [&str; 5] = ["lib", "build", "real", "scalars", "geometry"];

fn charts(folder: &Path) -> Vec<String> {
    let files = fs::read_dir(folder).expect("the folder of the crate can be read");
    let mut found: Vec<String> = files
        .filter_map(|file| file.ok()?.file_name().into_string().ok()?.strip_suffix(".rs").map(String::from))
        .filter(|name| !OWN.contains(&name.as_str()))
        .collect();
    found.sort();
    found
}

fn main() {
    println!("cargo:rerun-if-changed=.");
    let root = env::var("CARGO_MANIFEST_DIR").expect("cargo names the folder of the crate");
    let out = env::var("OUT_DIR").expect("cargo names the folder of the build");
    for (list, folder) in [("charts.rs", Path::new(&root).to_path_buf()), ("rotations.rs", Path::new(&root).join("rotation"))] {
        let lines = charts(&folder).into_iter().map(|name| {
            format!("#[path = {:?}]\npub mod {name};\n", folder.join(format!("{name}.rs")))
        });
        fs::write(Path::new(&out).join(list), lines.collect::<String>()).expect("the list of charts can be written");
    }
}
