-- The entries that citeproc makes of a bibliography, as a list, each behind its key.

-- citeproc is done: what kept the capitals of titles is not needed any more.
function Span(span)
  return span.classes:includes('nocase') and span.content or nil
end

function Link(link)
  local number = link.target:match('^https://arxiv%.org/abs/(.+)$')
  if number then link.content = { pandoc.Str('arXiv\u{a0}' .. number) } end
  return link
end

function Div(block)
  if block.identifier ~= 'refs' then return nil end
  local items = pandoc.List()
  for _, entry in ipairs(block.content) do
    local key = entry.identifier:gsub('^ref%-', '')
    local line = pandoc.List({ pandoc.Strong({ pandoc.Str(key) }), pandoc.Str(':'), pandoc.Space() })
    line:extend(entry.content[1].content)
    items:insert({ pandoc.Plain(line) })
  end
  return pandoc.BulletList(items)
end
