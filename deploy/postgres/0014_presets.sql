-- Presets of other slicers: files under a name, revision by revision.

CREATE TABLE presets (
  tenant          TEXT   NOT NULL,
  name            TEXT   NOT NULL COLLATE "C",
  revision        BIGINT NOT NULL,
  settings        BYTEA  NOT NULL,
  settings_digest TEXT   NOT NULL,
  create_us       BIGINT NOT NULL,
  PRIMARY KEY (tenant, name, revision)
);
