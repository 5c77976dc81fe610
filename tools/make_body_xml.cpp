// make_body_xml DATA OUT: writes the body file from the tables of facts.
#include <exception>
#include <fstream>
#include <iostream>

#include "twin/body/make_xml/body_xml.hpp"

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << "usage: make_body_xml FOLDER_OF_TABLES FILE.xml\n";
    return 2;
  }
  const std::string xml = darwinop::twin::bodyXml(argv[1]);
  std::ofstream file{argv[2]};
  file << xml;
  file.close();
  if (!file) {
    std::cerr << argv[2] << ": cannot be written\n";
    return 1;
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
