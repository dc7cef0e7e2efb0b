// SPDX-License-Identifier: MIT
// What serve.mjs does, for lines of JSON whose items are flat arrays of numbers.
use std::io::{BufRead, Write};

fn value<'a>(line: &'a str, key: &str) -> &'a str {
    let start = line.find(&format!("\"{}\": ", key)).expect(key) + key.len() + 4;
    let end = line[start..].find(|c| c == ',' || c == '}').unwrap_or(line.len() - start);
    line[start..start + end].trim_matches('"')
}

pub fn serve(answer: fn(&str, &[f64], &[f64]) -> Vec<f64>) {
    std::panic::set_hook(Box::new(|_| ()));
    for line in std::io::stdin().lock().lines().map(|line| line.unwrap()) {
        let degree: usize = value(&line, "degree").parse().unwrap();
        let items = line[line.find("[[").unwrap() + 2..].split('[').map(|item| {
            let numbers: Vec<f64> = item.split(|c| c == ',' || c == ']').filter_map(|number| number.trim().parse().ok()).collect();
            let (control, asked) = numbers.split_at(2 * degree + 2);
            match std::panic::catch_unwind(|| answer(value(&line, "problem"), control, asked)) {
                Ok(values) if values.iter().all(|value| value.is_finite()) => format!("{:?}", values),
                _ => "null".to_string(),
            }
        });
        println!("[{}]", items.collect::<Vec<_>>().join(","));
        std::io::stdout().flush().unwrap();
    }
}
