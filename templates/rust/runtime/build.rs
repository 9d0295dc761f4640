//! Lists the charts of the crate, so that a new one needs no line elsewhere.
use std::{env, fs, path::Path};

/// Names of the charts: each has a file in the folder of rotations.
fn charts(folder: &Path) -> Vec<String> {
    let files = fs::read_dir(folder).expect("the folder of rotations can be read");
    let mut found: Vec<String> = files
        .filter_map(|file| file.ok()?.file_name().into_string().ok()?.strip_suffix(".rs").map(String::from))
        .filter(|name| name != "geometry")
        .collect();
    found.sort();
    found
}

fn main() {
    println!("cargo:rerun-if-changed=rotation");
    let root = env::var("CARGO_MANIFEST_DIR").expect("cargo names the folder of the crate");
    let out = env::var("OUT_DIR").expect("cargo names the folder of the build");
    let (poses, rotations) = (Path::new(&root), Path::new(&root).join("rotation"));
    for (list, folder) in [("charts.rs", poses), ("rotations.rs", &rotations)] {
        let lines = charts(&rotations).into_iter().map(|name| {
            let file = folder.join(format!("{name}.rs"));
            format!("#[allow(non_snake_case)]\n#[path = {file:?}]\npub mod {name};\n")
        });
        fs::write(Path::new(&out).join(list), lines.collect::<String>()).expect("the list of charts can be written");
    }
}
