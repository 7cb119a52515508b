// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files/Gzip_decoder.h"

#include "basis/Failure.h"

#include <zlib.h>

#include <limits>
#include <new>
#include <utility>

namespace l0_tool {
namespace {

constexpr std::uint64_t maximum_ratio = 200, allowance = 1024 * 1024;
constexpr std::size_t input_size = 64 * 1024;
constexpr int with_gzip_header = 16;

} // namespace

struct Gzip_decoder::Stream
{
  z_stream state = {};

  Stream()
  {
    if (inflateInit2(&state, MAX_WBITS + with_gzip_header) != Z_OK)
      throw std::bad_alloc();
  }
  ~Stream() { inflateEnd(&state); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
};

std::uint64_t Gzip_decoder::maximum_bytes_of(std::uint64_t compressed_bytes)
{
  constexpr std::uint64_t most = (std::numeric_limits<std::uint64_t>::max)();
  return compressed_bytes > (most - allowance) / maximum_ratio
           ? most
           : maximum_ratio * compressed_bytes + allowance;
}

Gzip_decoder::Gzip_decoder(const std::string& name, std::string_view begin, Source source)
  : m_name(name), m_source(std::move(source)), m_input(begin), m_stream(new Stream)
{
  m_stream->state.next_in = reinterpret_cast<Bytef*>(m_input.data());
  m_stream->state.avail_in = uInt(m_input.size());
}

Gzip_decoder::~Gzip_decoder() = default;

void Gzip_decoder::refuse(const std::string& what) const
{
  throw Failure(INPUT_REFUSED, m_name + ": " + what);
}

bool Gzip_decoder::has_input()
{
  z_stream& state = m_stream->state;
  if (state.avail_in > 0)
    return true;
  m_input.resize(input_size);
  const std::size_t n = m_source(m_input.data(), m_input.size());
  state.next_in = reinterpret_cast<Bytef*>(m_input.data());
  state.avail_in = uInt(n);
  return n > 0;
}

std::size_t Gzip_decoder::read(char* target, std::size_t n)
{
  z_stream& state = m_stream->state;
  state.next_out = reinterpret_cast<Bytef*>(target);
  state.avail_out = uInt(n);
  while (state.avail_out == n) {
    if (!has_input()) {
      if (m_is_within_member)
        refuse("the compressed data end early");
      return 0;
    }
    if (!m_is_within_member)
      inflateReset(&state);
    m_is_within_member = true;
    const uInt available = state.avail_in;
    const int status = inflate(&state, Z_NO_FLUSH);
    m_compressed_bytes += available - state.avail_in;
    if (status == Z_MEM_ERROR)
      throw std::bad_alloc();
    if (status == Z_STREAM_END)
      m_is_within_member = false;
    else if (status != Z_OK && status != Z_BUF_ERROR)
      refuse(std::string("the compressed data are damaged: ")
             + (state.msg ? state.msg : "not what gzip writes"));
  }
  const std::size_t written = n - state.avail_out;
  m_bytes += written;
  if (m_bytes > maximum_bytes_of(m_compressed_bytes))
    refuse("the compressed data stand for more than " + std::to_string(maximum_ratio)
           + " times as many bytes; gunzip it first, if it is what it should be");
  return written;
}

} // namespace l0_tool
