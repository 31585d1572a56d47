use imogene::failure::Failure;
use std::error::Error;
use std::fmt;

#[test]
fn causes_are_said_once() {
    #[derive(Debug)]
    struct Said(&'static str, Option<Box<Said>>);
    impl fmt::Display for Said {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str(self.0)
        }
    }
    impl Error for Said {
        fn source(&self) -> Option<&(dyn Error + 'static)> {
            self.1.as_deref().map(|cause| cause as &dyn Error)
        }
    }
    let cause = |text| Some(Box::new(Said(text, None)));
    let failure = |error: Said| Failure::from(error).message().unwrap();
    let whole = "no picture: disk full";
    for said in ["no picture", whole] {
        assert_eq!(failure(Said(said, cause("disk full"))), whole);
    }
    assert_eq!(failure(Said("no picture", None)), "no picture");
}

#[test]
fn long_words_lines_and_messages_lose_their_middle() {
    let short = "scene.toml:1:2: key `radius` is 3\n  1 | radius = 3";
    let whole = Failure::Input(short.into()).message();
    assert_eq!(whole.as_deref(), Some(short));
    let key = "ä.".repeat(500_000);
    let message = Failure::Input(format!("begin {key} end\n{}", "a ".repeat(100_000)));
    let said = message.message().unwrap();
    assert!(said.starts_with("begin ä.ä.") && said.contains(".ä. end\na a"));
    assert!(said.contains("[.. 999801 characters ..]"), "{said}");
    let many = Failure::Input("line\n".repeat(10_000));
    assert!(many.message().unwrap().len() < 2_000);
    let list = "  pixel (1, 2)\n".repeat(10_000);
    assert_eq!(Failure::Check(list.clone()).message().unwrap(), list);
}
