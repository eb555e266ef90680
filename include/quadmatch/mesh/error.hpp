#pragma once
/// What can go wrong with a user's input: a closed list of causes, and one sentence a modeller understands.

#include <cstdint>
#include <string>

namespace quadmatch {

enum class ErrorCode {
  CannotRead,       ///< missing, unreadable, or a folder
  CannotWrite,      ///< no permission, no room
  UnknownFormat,    ///< neither the name nor the first bytes say what it is
  Syntax,           ///< the text does not follow its format
  BadNumber,        ///< not a number, or out of range
  BadIndex,         ///< an element names one that does not exist
  TooFewCorners,    ///< a face of fewer than three corners
  Truncated,        ///< the file ends in the middle of an element
  TooLarge,         ///< more elements than a 32-bit id can name
  Empty,            ///< no face at all
  MatchDoesNotFit,  ///< a match file for other meshes
  BadArgument,      ///< an option that contradicts the meshes, e.g. an anchor that names no face
  Cancelled,        ///< the caller's progress function said stop
};

/// Bad input, said so that its owner can mend it.
struct Error {
  ErrorCode code = ErrorCode::Syntax;
  /// What is wrong, and what to do: one sentence without a full stop, no line breaks.
  std::string message;
  /// The file, empty when none is meant.
  std::string path = {};
  /// Line in the file, from 1; 0 when none is meant.
  std::uint64_t line = 0;

  /// `path:line: message`, leaving out what is not known.
  [[nodiscard]] std::string describe() const;
};

}  // namespace quadmatch
