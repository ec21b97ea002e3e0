-- What one coordinator at a time does for all; and specs apart from the rows of jobs, which are written several times, from half of
-- the usual length on.

CREATE TABLE chores (
  name     TEXT   PRIMARY KEY,
  until_us BIGINT NOT NULL  -- nobody else does it before
);

ALTER TABLE jobs SET (toast_tuple_target = 1024);
