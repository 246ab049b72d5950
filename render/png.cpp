#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>

#include "render/file.hpp"
#include "render/outputs.hpp"

namespace seiche::render {

void write_png(const std::filesystem::path& file, const Image& image,
               const std::vector<std::pair<std::string, std::string>>& text) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y)
    std::memcpy(data->GetScalarPointer(0, image.height - 1 - y, 0), &image.rgba[row * y], row);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(data);
  writer->SetCompressionLevel(2);
  writer->WriteToMemoryOn();
  for (const auto& [keyword, value] : text) writer->AddText(keyword.c_str(), value.c_str());
  writer->Write();
  const vtkUnsignedCharArray* bytes = writer->GetResult();
  write_file(file, {reinterpret_cast<const char*>(const_cast<vtkUnsignedCharArray*>(bytes)->GetPointer(0)),
                    static_cast<std::size_t>(bytes->GetNumberOfValues())});
}

}  // namespace seiche::render
