-- Settings under a name. A revision never changes and never goes away.

CREATE TABLE profiles (
  tenant          TEXT   NOT NULL,
  name            TEXT   NOT NULL COLLATE "C",
  revision        BIGINT NOT NULL,
  settings        BYTEA  NOT NULL,
  settings_digest TEXT   NOT NULL,
  create_us       BIGINT NOT NULL,
  PRIMARY KEY (tenant, name, revision)
);
