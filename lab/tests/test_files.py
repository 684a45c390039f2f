"""Files that are written whole, and names that stay different."""

import os
import stat
import unittest

from drc_lab.files import check_writable, file_name, state_of, write_whole
from lab_testing import FolderTest


class Files(FolderTest):
    def test_are_replaced_with_their_permissions(self):
        path = self.folder / "page.html"
        write_whole(path, "first")
        self.assertEqual(stat.S_IMODE(path.stat().st_mode), 0o666 & ~self.umask())
        path.chmod(0o640)
        write_whole(path, b"second")
        self.assertEqual((path.read_text(), stat.S_IMODE(path.stat().st_mode)), ("second", 0o640))
        self.assertEqual(os.listdir(self.folder), ["page.html"])

    def test_links_stay(self):
        (self.folder / "link").symlink_to("page.html")
        write_whole(self.folder / "link", "text")
        self.assertTrue((self.folder / "link").is_symlink())
        self.assertEqual((self.folder / "page.html").read_text(), "text")

    def test_devices_are_not_replaced(self):
        write_whole("/dev/null", "text")
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_a_failure_leaves_the_old_file_and_nothing_else(self):
        path = self.folder / "page.html"
        path.write_text("old")
        with self.assertRaises(TypeError):
            write_whole(path, None)
        self.assert_error(lambda: write_whole(self.folder / "no" / "page.html", "new"), "cannot write", "No such file")
        self.assertEqual((path.read_text(), os.listdir(self.folder)), ("old", ["page.html"]))

    def test_that_cannot_be_written_are_known_before(self):
        check_writable("-o", self.folder / "new")
        self.assert_error(lambda: check_writable("-o", self.folder), "-o", "is a folder")
        self.assert_error(lambda: check_writable("-o", self.folder / "no" / "file"), "there is no folder")

    def test_have_a_state_that_changes(self):
        path = self.folder / "scene.pbrt"
        path.write_text("one")
        os.utime(path, ns=(0, 6437664000 * 10**9 + 5))  # the year 2174, in which the clock of the records starts
        self.assertEqual(state_of(path), "3:5")
        self.assertEqual(state_of(self.folder / "none"), "")

    @staticmethod
    def umask():
        mask = os.umask(0)
        os.umask(mask)
        return mask


class Names(unittest.TestCase):
    def test_that_are_safe_stay(self):
        for name in ("room", "path+oidn", "drc-maps", "a.b"):
            self.assertEqual(file_name(name), name)

    def test_others_stay_different(self):
        self.assertEqual(file_name("chongo was here!\n"), "_chongo_was_here__-d49930d5")  # a published value of FNV-1a
        self.assertEqual(file_name("\u00e9")[:4], "___-")  # one for each byte
        self.assertEqual(len({file_name(name) for name in ("a:b", "a/b", "a b", "a_b", "..", "_a")}), 6)
        self.assertNotIn("/", file_name("../a"))
        self.assertFalse(file_name("..").startswith("."))


if __name__ == "__main__":
    unittest.main()
