#pragma once

#include <string_view>

namespace unstep::codec {

/// What lists of metadata often hold, as the dictionary of their deflate
/// streams; the likeliest last. Part of the format: it must never change.
// Zero bytes inside, so no string_view literal.
inline constexpr char kMetadataText[] =
    "unstep:pulses\0unstep:pixels\0png:Warning\0png:Disclaimer\0"
    "png:Comment\0png:Creation Time\0png:Description\0png:Author\0png:Title\0"
    "png:date:timestamp\0png:date:create\0png:date:modify\0"
    "-01-01T00:00:00+00:00\0png:Software\0"
    "tiff:TargetPrinter\0tiff:HostComputer\0tiff:Copyright\0tiff:Artist\0"
    "tiff:PageName\0tiff:Make\0tiff:Model\0tiff:DateTime\0"
    "2000:01:01 00:00:00\0tiff:Photometric\0MinIsBlack\0"
    "tiff:Software\0ImageMagick\0www.inkscape.org\0Adobe Photoshop\0GIMP 2.10\0"
    "GPL Ghostscript\0IrfanView\0libtiff\0ScanTailor\0"
    "tiff:DocumentName\0Standard Input\0"
    "tiff:ImageDescription\0converted PNM file\0"
    "unstep:source-size\0unstep:source-crc32\0";

inline constexpr std::string_view kMetadataWords{kMetadataText,
                                                 sizeof(kMetadataText) - 1};

}  // namespace unstep::codec
