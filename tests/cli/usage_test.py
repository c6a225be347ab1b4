"""The command line itself: versions, help, wrong usage."""

import harness
from harness import VERSION


class Usage(harness.CliTest):
    def test_version_names_program_and_format(self):
        self.expect(["--version"],
                    out=f"unstep {VERSION} (format 0, pre-release)\n")

    def test_help_lists_verbs_and_exit_codes(self):
        out = self.expect(["--help"]).out
        for verb in ["compress", "decompress", "verify", "info", "batch"]:
            self.assertIn(f"\n  {verb} ", out)
        for code in ["0 ", "1 ", "2 ", "3 ", "4 ", "5 ", "130 "]:
            self.assertIn(f"\n  {code}", out)

    def test_every_verb_has_examples_and_exit_codes(self):
        for verb in ["compress", "decompress", "verify", "info", "batch",
                     "interpolate", "reverse", "simulate"]:
            out = self.expect([verb, "--help"]).out
            self.assertIn("Examples:\n  unstep " + verb, out)
            self.assertIn("Exit codes:\n", out)
            self.assertTrue(all(len(line) <= 80 for line in out.split("\n")),
                            verb)

    def test_no_verb(self):
        self.expect_error([], 2, "unstep: A subcommand is required "
                          "(see unstep --help)\n")

    def test_unknown_verb(self):
        result = self.run_cli("shrink", "a.pbm")
        self.assertEqual(result.code, 2)
        self.assertEqual(result.out, "")
        self.assertEqual(result.err.count("\n"), 1)

    def test_unknown_option(self):
        self.expect_error(
            ["compress", "a.pbm", "--fast"], 2,
            "unstep: The following argument was not expected: --fast "
            "(see unstep compress --help)\n")

    def test_missing_input(self):
        self.expect_error(["compress"], 2, "unstep: IN is required "
                          "(see unstep compress --help)\n")

    def bad_option(self, option, value, reason):
        self.expect_error(
            ["compress", "a.pbm", option, value], 2,
            f"unstep: {option}: {reason} (see unstep compress --help)\n")

    def test_bad_counts(self):
        number = "is not a whole number, with K, M, G, Ki, Mi or Gi"
        for value in ["many", "", "1.5", "-1", "3Q", "1 K", "0x10", "12k"]:
            self.bad_option("--max-pixels", value, f"'{value}' {number}")
        self.bad_option("--max-memory", "99999999999999999999",
                        "'99999999999999999999' is too large")
        self.bad_option("--max-memory", "99999999999999999G",
                        "'99999999999999999G' is too large")
        self.bad_option("--jobs", "0", "'0' is not within 1 to 1024")
        self.bad_option("--bands", "0", "'0' is not within 1 to 65535")

    def test_bad_threshold(self):
        for value in ["0", "256", "dark", "-3"]:
            self.bad_option(
                "--threshold", value,
                f"'{value}' is neither a level of 1 to 255 nor auto, otsu, "
                "sauvola or local")
        self.bad_option("--invert", "maybe", "'maybe' is not auto, yes or no")
        self.bad_option("--despeckle", "2M",
                        "'2M' is not within 0 to 1000000")

    def test_bad_decoding(self):
        self.bad_option("--channels", "a", "'a' is not A,B or XA,XB,YA,YB")
        self.bad_option("--counts", "x3", "'x3' is not x1, x2 or x4")
        for value in ["1", "2,1", "1,1", "a,b", "1,2,3"]:
            self.bad_option("--trigger", value,
                            f"'{value}' is not LOW,HIGH, the lower first")

    def test_bad_metadata(self):
        self.bad_option("--meta", "title", "'title' is not key=value")
        self.bad_option("--meta", "=x", "'=x' is not key=value")
        self.bad_option("--meta", "unstep:source-size=1",
                        "'unstep:source-size=1': keys of unstep: are the "
                        "program's own")
        self.expect_error(
            ["compress", "a.pbm", "--meta", "a=1", "--meta", "a=2"], 2,
            "unstep: --meta: key 'a' is given twice "
            "(see unstep compress --help)\n")

    def test_bad_kind_and_format(self):
        self.bad_option("--from", "pdf", "'pdf' is not raster, svg, dxf, hpgl, "
                        "json, freeman, csv, vcd, sr, raw2 or raw4")
        self.expect_error(
            ["decompress", "a.ustp", "--to", "jpg"], 2,
            "unstep: --to: 'jpg' is not png, pbm, tif, svg, dxf, pdf, hpgl, "
            "json, fc or ngc (see unstep decompress --help)\n")


if __name__ == "__main__":
    harness.main()
